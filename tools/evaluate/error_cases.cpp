// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/error_cases.hpp"

#include <algorithm>
#include <cmath>

#include "fallen/evaluation/frame_outcome.hpp"

namespace fallen {
namespace {

constexpr char kFallenPerson[] = "fallen_person";
constexpr double kSameThingM = 1.0;    // along the floor
constexpr double kBesideThingM = 0.4;  // of a labelled box, for what is flagged to be that thing

/// Distance from a point to a box along the floor.
double DistanceTo(const OrientedBox& box, const Eigen::Vector3d& p) {
  const Eigen::Vector2d local = Eigen::Rotation2Dd(-box.yaw) * (p - box.center).head<2>();
  return (local.cwiseAbs() - box.size.head<2>() / 2).cwiseMax(0).norm();
}

/// What is labelled nearest to a place. Furniture only where nothing else is: a dog on a carpet is
/// a dog.
std::string KindAt(const Eigen::Vector3d& place, const GroundTruth& truth) {
  std::string kind = "unlabelled";
  double nearest = kBesideThingM;
  const auto consider = [&](const std::string& name, const OrientedBox& box, double handicap) {
    const double distance = DistanceTo(box, place) + handicap;
    if (distance >= nearest) return;
    nearest = distance;
    kind = name;
  };
  constexpr double kFurnitureHandicapM = 0.2;
  for (const LabelledObject& object : truth.objects)
    if (object.category != kFallenPerson)
      consider(object.category, object.box,
               object.category == "furniture" ? kFurnitureHandicapM : 0);
  if (truth.person_box) consider("beside_fallen_person", *truth.person_box, 0);
  return kind;
}

}  // namespace

CaseCollector::Seen& CaseCollector::Find(bool is_miss, const Eigen::Vector3d& place) {
  for (Seen& seen : seen_)
    if (seen.what.is_miss == is_miss && (seen.what.place - place).head<2>().norm() < kSameThingM)
      return seen;
  Seen& seen = seen_.emplace_back();
  seen.what.is_miss = is_miss;
  seen.what.log = log_;
  seen.what.place = place;
  return seen;
}

void CaseCollector::AddPerson(std::int64_t number, const Decision& decision,
                              const GroundTruth& truth, int cells_in_box) {
  double best = 0;
  for (const PersonHypothesis& hypothesis : decision.hypotheses)
    if (truth.person_box->Contains(hypothesis.centroid))
      best = std::max(best, hypothesis.probability);
  Seen& seen = Find(true, truth.person_box->center);
  seen.what.kind = kFallenPerson;
  seen.what.probability = std::max(seen.what.probability, best);
  ++seen.what.frames;
  const bool is_missed = best < decision.min_probability;
  seen.what.at_fault += is_missed;
  if (!is_missed || cells_in_box <= seen.rank) return;
  seen.rank = cells_in_box;
  seen.what.frame = number;
}

void CaseCollector::AddFalseAlarm(std::int64_t number, const PersonHypothesis& hypothesis,
                                  const GroundTruth& truth, double min_probability) {
  Seen& seen = Find(false, hypothesis.centroid);
  ++seen.what.frames;
  seen.what.at_fault += hypothesis.probability >= min_probability;
  if (hypothesis.probability <= seen.rank) return;
  seen.rank = seen.what.probability = hypothesis.probability;
  seen.what.place = hypothesis.centroid;
  seen.what.kind = KindAt(hypothesis.centroid, truth);
  seen.what.frame = number;
}

void CaseCollector::Add(std::int64_t number, const Decision& decision, const GroundTruth& truth,
                        int cells_in_box) {
  if (truth.person_box && cells_in_box >= kMinCellsInBox)
    AddPerson(number, decision, truth, cells_in_box);
  for (const PersonHypothesis& hypothesis : decision.hypotheses)
    if (!truth.person_box || !truth.person_box->Contains(hypothesis.centroid))
      AddFalseAlarm(number, hypothesis, truth, decision.min_probability);
}

std::vector<ErrorCase> CaseCollector::cases() const {
  std::vector<ErrorCase> cases;
  for (const Seen& seen : seen_) cases.push_back(seen.what);
  return cases;
}

WorstCases PickWorstCases(std::vector<ErrorCase> cases, std::size_t count) {
  WorstCases worst;
  for (ErrorCase& error : cases) {
    if (error.at_fault == 0) continue;
    (error.is_miss ? worst.misses : worst.false_alarms).push_back(std::move(error));
  }
  const auto keep = [count](std::vector<ErrorCase>& list, int sign) {
    std::stable_sort(list.begin(), list.end(), [sign](const ErrorCase& a, const ErrorCase& b) {
      if (a.probability != b.probability) return sign * a.probability < sign * b.probability;
      return a.at_fault > b.at_fault;
    });
    if (list.size() > count) list.resize(count);
  };
  keep(worst.misses, 1);
  keep(worst.false_alarms, -1);
  return worst;
}

nlohmann::json ToJson(const ErrorCase& error) {
  return {{"recording", error.log},
          {"frame", error.frame},
          {"place", {error.place.x(), error.place.y(), error.place.z()}},
          {"p", error.probability},
          {"kind", error.kind},
          {"frames", error.frames},
          {"at_fault", error.at_fault}};
}

}  // namespace fallen
