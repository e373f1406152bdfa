// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/neighbor_grid.hpp"

namespace fallen {

/// Cluster index of a point that belongs to none.
inline constexpr std::int32_t kNoise = -1;

/// DBSCAN (the paper, Sec. III-D.4).
///
/// [Ester96] Ester, Kriegel, Sander, Xu: A density-based algorithm for discovering clusters in
/// large
///           spatial databases with noise. KDD 1996.
/// A core point has at least `min_points` points within `epsilon_m`, itself included. A border
/// point goes to the cluster of its nearest core point, where [Ester96] leaves it to the first that
/// finds it (ties: the core point of the smaller index), so the result does not depend on the order
/// of the points but for such ties and the numbering of the clusters.
/// @return One label a point: kNoise, or 0, 1, ... in the order of the clusters' first core points.
/// @throws std::invalid_argument if a point is not finite, `epsilon_m` is not > 0 or `min_points`
/// < 1. Deterministic. Thread-safe. O(pairs within epsilon_m).
std::vector<std::int32_t> Dbscan(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                 int min_points);

/// Dbscan for frame after frame in the same memory. Not thread-safe.
class PointClusterer {
 public:
  /// As Dbscan. The labels hold until the next call.
  const std::vector<std::int32_t>& Label(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                         int min_points);

 private:
  void FindCorePoints(std::span<const Eigen::Vector3f> points, float epsilon_m, int min_points);
  void LabelConnectedCores(std::span<const Eigen::Vector3f> points, float epsilon_m,
                           std::int32_t seed, std::int32_t cluster);

  NeighborGrid grid_;
  std::vector<std::uint8_t> is_core_;
  std::vector<std::int32_t> labels_;
  std::vector<std::int32_t> open_;
};

}  // namespace fallen
