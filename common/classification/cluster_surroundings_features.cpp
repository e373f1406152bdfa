// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "fallen/classification/cluster_feature_blocks.hpp"

namespace fallen {
namespace {

constexpr double kAround = 0.1;                 // [m]
constexpr double kBeside = 0.4;                 // [m]
constexpr double kAbove = 0.5;                  // [m]
constexpr float kTall = 0.5F;                   // [m], higher than what lies
constexpr std::array kRings = {0.3, 0.6, 1.0};  // [m]

// The cells that are not the cluster's own.
template <class Visit>
void ForEachOther(const PlacedCluster& cluster, Visit&& visit) {
  const auto& cells = cluster.scene.segmented.cells;
  auto member = cluster.cluster.cells.begin();  // ascending
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (member != cluster.cluster.cells.end() && *member == static_cast<std::int32_t>(i)) {
      ++member;
      continue;
    }
    visit(cells[i], cluster.scene.heights_m[i]);
  }
}

void AddBoxNeighbors(const PlacedCluster& cluster, FeatureRow& row) {
  const auto by_height = [](const PlacedCell& a, const PlacedCell& b) {
    return a.height < b.height;
  };
  const auto [low, high] =
      std::minmax_element(cluster.cells.begin(), cluster.cells.end(), by_height);
  const float lowest = low->height, highest = high->height;
  const OrientedBox& box = cluster.box;
  const FloorFrame frame(box.center.head<2>(), {std::cos(box.yaw), std::sin(box.yaw)});
  const Eigen::Vector2d half = box.size.head<2>() / 2;
  int within = 0, above = 0, below = 0, beside = 0;
  double score_sum = 0;
  ForEachOther(cluster, [&](const ScoredCell& scored, float height) {
    const Eigen::Vector2d place = frame.Place(scored.mean.head<2>().cast<double>());
    const double out = (place.cwiseAbs() - half).maxCoeff();
    if (out > kBeside || height > highest + kAbove) return;
    if (out > kAround) {
      beside += height <= highest;
    } else if (height > highest) {
      ++above;
    } else if (height < lowest) {
      ++below;
    } else {
      ++within;
      score_sum += scored.score;
    }
  });
  const auto own = static_cast<double>(cluster.cells.size());
  row.Add(within / own, above / own, below / own, beside / own,
          within > 0 ? score_sum / within : 0.0);
}

void AddRings(const PlacedCluster& cluster, FeatureRow& row) {
  struct Ring {
    int count = 0;
    int tall = 0;
    float highest = 0;
    float best_score = -1;
  };
  std::array<Ring, kRings.size()> rings;
  const Eigen::Vector2d half(cluster.length / 2, 2 * cluster.deviation_across);
  ForEachOther(cluster, [&](const ScoredCell& scored, float height) {
    const Eigen::Vector2d place = cluster.frame.Place(scored.mean.head<2>().cast<double>());
    const double distance = (place.cwiseAbs() - half).cwiseMax(0.0).norm();
    for (std::size_t r = 0; r < kRings.size(); ++r) {
      if (distance >= kRings[r]) continue;
      ++rings[r].count;
      rings[r].tall += height > kTall;
      rings[r].highest = std::max(rings[r].highest, height);
      rings[r].best_score = std::max(rings[r].best_score, scored.score);
    }
  });
  const auto own = static_cast<double>(cluster.cells.size());
  for (const Ring& ring : rings)
    row.Add(ring.count / own, ring.tall / own, ring.highest, ring.best_score);
}

}  // namespace

void AddSurroundings(const PlacedCluster& cluster, FeatureRow& row) {
  AddBoxNeighbors(cluster, row);
  AddRings(cluster, row);
}

}  // namespace fallen
