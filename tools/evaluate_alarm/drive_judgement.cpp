// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_alarm/drive_judgement.hpp"

#include <algorithm>
#include <utility>

namespace fallen {
namespace {

// Centroids of what is seen of a person lie on this side of the person.
constexpr double kBoxMargin_m = 0.3;
// False clusters nearer to each other than this are one false alarm: AlarmConfig's
// match_distance_m.
constexpr double kSamePlace_m = 0.8;

double Seconds(std::int64_t from_utime, std::int64_t to_utime) {
  return std::max(0.0, static_cast<double>(to_utime - from_utime) * 1e-6);
}

bool IsAt(std::optional<OrientedBox> box, const Eigen::Vector3d& position) {
  if (!box) return false;
  box->size.array() += 2 * kBoxMargin_m;
  return box->Contains(position);
}

/// The person's comings and goings.
struct Presence {
  std::optional<OrientedBox> last_box;
  std::optional<std::int64_t> view_utime;  ///< came into view
  std::optional<std::int64_t> left_utime;  ///< is there no more

  void Note(const TracedFrame& frame) {
    if (frame.is_in_view && !view_utime) view_utime = frame.utime;
    if (!frame.person_box && last_box && !left_utime) left_utime = frame.utime;
    if (frame.person_box) last_box = frame.person_box;
  }
};

void Score(const FallAlarm& change, const TracedFrame& frame, const Presence& presence,
           std::string& found_id, std::optional<std::int64_t>& found_utime, AlarmOutcome& outcome) {
  if (change.change == AlarmChange::kRaised) {
    if (!IsAt(frame.person_box, change.position)) {
      ++outcome.false_alarms;
    } else if (!found_utime) {
      found_utime = frame.utime;
      found_id = change.id;
      outcome.views = change.views;
    }
  }
  if (change.change == AlarmChange::kCleared && change.id == found_id && presence.left_utime)
    outcome.seconds_until_cleared = Seconds(*presence.left_utime, frame.utime);
}

void ScoreClusters(const TracedFrame& frame, std::vector<Eigen::Vector3d>& false_places,
                   std::optional<std::int64_t>& found_utime, AlarmOutcome& outcome) {
  for (const PersonHypothesis& person : frame.decision.hypotheses) {
    if (!person.is_person) continue;
    if (IsAt(frame.person_box, person.centroid)) {
      if (!found_utime) found_utime = frame.utime;
      outcome.views = 1;
      continue;
    }
    const bool is_known =
        std::any_of(false_places.begin(), false_places.end(), [&](const Eigen::Vector3d& place) {
          return (place - person.centroid).norm() < kSamePlace_m;
        });
    if (is_known) continue;
    false_places.push_back(person.centroid);
    ++outcome.false_alarms;
  }
}

std::optional<double> Delay(const Presence& presence, std::optional<std::int64_t> found_utime) {
  if (!presence.view_utime || !found_utime) return std::nullopt;
  return Seconds(*presence.view_utime, *found_utime);
}

}  // namespace

DriveOutcome JudgeDrive(const DriveTrace& trace, AlarmFusion fusion) {
  DriveOutcome outcome;
  outcome.log = trace.log;
  Presence presence;
  std::string found_id;
  std::optional<std::int64_t> alarm_utime, cluster_utime;
  std::vector<Eigen::Vector3d> false_places;
  for (const TracedFrame& frame : trace.frames) {
    presence.Note(frame);
    for (const FallAlarm& change : fusion.Add(frame.utime, trace.camera, frame.decision))
      Score(change, frame, presence, found_id, alarm_utime, outcome.alarm);
    ScoreClusters(frame, false_places, cluster_utime, outcome.single_frame);
  }
  const std::size_t n = trace.frames.size();
  const double span = Seconds(trace.frames.front().utime, trace.frames.back().utime);
  outcome.seconds = n > 1 ? span * static_cast<double>(n) / static_cast<double>(n - 1) : 0;
  outcome.has_person = presence.last_box.has_value();
  outcome.came_into_view = presence.view_utime.has_value();
  outcome.person_left = presence.left_utime.has_value() && alarm_utime.has_value();
  outcome.alarm.seconds_until = Delay(presence, alarm_utime);
  outcome.single_frame.seconds_until = Delay(presence, cluster_utime);
  return outcome;
}

}  // namespace fallen
