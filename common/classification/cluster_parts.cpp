// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

constexpr std::size_t kMinCells = 40;
constexpr double kMaxShare = 0.95;
constexpr float kScoreShares[] = {1.0F / 3, 2.0F / 3};
constexpr double kHighQuantile = 0.95;
constexpr double kEpsilonInCells = 2;  // DBSCAN's radius, in cells
constexpr int kMinPoints = 6;
constexpr double kPersonWidth = 1.1;    // [m], arms and legs apart
constexpr double kMinDeviation = 0.25;  // [m], of members that are worth a cut
constexpr int kCuts = 2;                // one after the other: halves, quarters
constexpr int kMeansSteps = 15;

using Members = KeptVector<std::int32_t>;  // positions in the cluster
using Centers = std::array<Eigen::Vector2d, 2>;

}  // namespace

class ClusterPartFinder::Search {
 public:
  Search(const SegmentedMap& segmented, const CellCluster& cluster, ClusterPartFinder& found)
      : segmented_(segmented), cluster_(cluster), found_(found) {}

  void CutByScore() {
    KeptVector<float> scores;
    for (std::size_t k = 0; k < cluster_.cells.size(); ++k) scores.push_back(Member(k).score);
    const auto high = scores.begin() + static_cast<std::ptrdiff_t>(
                                           kHighQuantile * static_cast<double>(scores.size() - 1));
    std::nth_element(scores.begin(), high, scores.end());
    for (const float share : kScoreShares) TakeScoresFrom(*high * share);
  }

  void CutByPlace() {
    Members all;
    all.resize(cluster_.cells.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int32_t>(k);
    Halve(all, kCuts);
  }

 private:
  const ScoredCell& Member(std::size_t k) const { return segmented_.cells[cluster_.cells[k]]; }
  Eigen::Vector2d Place(std::size_t k) const { return Member(k).mean.head<2>().cast<double>(); }

  void Add(const Members& members) {
    const auto most = kMaxShare * static_cast<double>(cluster_.cells.size());
    if (members.size() < kMinCells || static_cast<double>(members.size()) > most) return;
    found_.members_.insert(found_.members_.end(), members.begin(), members.end());
    found_.ends_.push_back(found_.members_.size());
  }

  void TakeScoresFrom(float min_score) {
    Members members, sizes;
    KeptVector<Eigen::Vector3f> points;
    for (std::size_t k = 0; k < cluster_.cells.size(); ++k) {
      if (Member(k).score < min_score) continue;
      members.push_back(static_cast<std::int32_t>(k));
      points.push_back(Member(k).mean);
    }
    const auto epsilon_m = static_cast<float>(kEpsilonInCells * segmented_.cell_size_m);
    const std::vector<std::int32_t>& labels =
        found_.clusterer_.Label(points, epsilon_m, kMinPoints);
    for (const std::int32_t label : labels) {
      if (label == kNoise) continue;
      if (static_cast<std::size_t>(label) >= sizes.size()) sizes.resize(label + 1, 0);
      ++sizes[label];
    }
    Members group;
    for (std::size_t label = 0; label < sizes.size(); ++label) {
      if (static_cast<std::size_t>(sizes[label]) < kMinCells) continue;
      group.clear();
      for (std::size_t p = 0; p < labels.size(); ++p)
        if (labels[p] == static_cast<std::int32_t>(label)) group.push_back(members[p]);
      Add(group);
    }
  }

  void Halve(const Members& members, int cuts) {
    if (cuts == 0 || members.size() < 2 * kMinCells) return;
    const std::optional<Centers> start = OneDeviationApart(members);
    if (!start) return;
    std::array<Members, 2> halves;
    TwoMeans(members, *start, halves);
    for (const Members& half : halves) {
      Add(half);
      Halve(half, cuts - 1);
    }
  }

  // One standard deviation to each side of the mean along the main axis, if that is far enough.
  std::optional<Centers> OneDeviationApart(const Members& members) const {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const std::int32_t k : members) mean += Place(k);
    const auto count = static_cast<double>(members.size());
    mean /= count;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const std::int32_t k : members)
      spread += (Place(k) - mean) * (Place(k) - mean).transpose() / count;
    const double half_difference = (spread(0, 0) - spread(1, 1)) / 2;
    const double deviation =
        std::sqrt(spread.trace() / 2 + std::hypot(half_difference, spread(0, 1)));
    if (!(deviation >= kMinDeviation)) return std::nullopt;
    const double angle = std::atan2(spread(0, 1), half_difference) / 2;
    const Eigen::Vector2d step = deviation * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return Centers{mean + step, mean - step};
  }

  void TwoMeans(const Members& members, Centers centers, std::array<Members, 2>& halves) const {
    for (int i = 0; i < kMeansSteps; ++i) {
      Centers sums = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
      for (Members& half : halves) half.clear();
      for (const std::int32_t k : members) {
        const Eigen::Vector2d place = Place(k);
        const int nearer = (place - centers[0]).squaredNorm() >= (place - centers[1]).squaredNorm();
        halves[nearer].push_back(k);
        sums[nearer] += place;
      }
      for (int h = 0; h < 2; ++h)
        if (!halves[h].empty()) centers[h] = sums[h] / static_cast<double>(halves[h].size());
    }
  }

  const SegmentedMap& segmented_;
  const CellCluster& cluster_;
  ClusterPartFinder& found_;
};

void ClusterPartFinder::Find(const SegmentedMap& segmented, const CellCluster& cluster,
                             const OrientedBox& box) {
  members_.clear();
  ends_.clear();
  if (cluster.cells.size() < kMinCells) return;
  Search search(segmented, cluster, *this);
  search.CutByScore();
  if (box.size.x() > kPersonLength_m || box.size.y() > kPersonWidth) search.CutByPlace();
}

void TakeMembers(const CellCluster& cluster, std::span<const std::int32_t> members,
                 CellCluster& part) {
  part.cells.clear();
  for (const std::int32_t k : members) part.cells.push_back(cluster.cells[k]);
  GrowDescriptors(part, cluster.descriptors.cols());
  for (std::size_t k = 0; k < members.size(); ++k)
    part.descriptors.row(static_cast<Eigen::Index>(k)) = cluster.descriptors.row(members[k]);
}

}  // namespace fallen
