// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/dbscan.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fallen/iron/neighbor_grid.hpp"

namespace fallen {
namespace {

[[noreturn]] void Fail(const std::string& what) { throw std::invalid_argument("dbscan: " + what); }

void Check(std::span<const Eigen::Vector3f> points, float epsilon_m, int min_points) {
  if (!(epsilon_m > 0) || !std::isfinite(epsilon_m))
    Fail("epsilon_m is " + std::to_string(epsilon_m) + ", must be > 0 and finite");
  if (min_points < 1) Fail("min_points is " + std::to_string(min_points) + ", must be >= 1");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite()) Fail("point " + std::to_string(i) + " is not finite");
}

std::vector<std::uint8_t> FindCorePoints(const NeighborGrid& grid,
                                         std::span<const Eigen::Vector3f> points, float epsilon_m,
                                         int min_points) {
  std::vector<std::uint8_t> is_core(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    int count = 0;
    grid.ForEachWithin(points[i], epsilon_m, [&](std::int32_t, float) { ++count; });
    is_core[i] = count >= min_points;
  }
  return is_core;
}

// Gives `cluster` to the core points that chains of core points, each within epsilon of the one
// before, connect with `seed`.
void LabelConnectedCores(const NeighborGrid& grid, std::span<const Eigen::Vector3f> points,
                         std::span<const std::uint8_t> is_core, float epsilon_m, std::int32_t seed,
                         std::int32_t cluster, std::vector<std::int32_t>& labels) {
  std::vector<std::int32_t> open{seed};
  labels[seed] = cluster;
  while (!open.empty()) {
    const std::int32_t core = open.back();
    open.pop_back();
    grid.ForEachWithin(points[core], epsilon_m, [&](std::int32_t neighbor, float) {
      if (!is_core[neighbor] || labels[neighbor] != kNoise) return;
      labels[neighbor] = cluster;
      open.push_back(neighbor);
    });
  }
}

std::int32_t NearestCore(const NeighborGrid& grid, const Eigen::Vector3f& point,
                         std::span<const std::uint8_t> is_core, float epsilon_m) {
  std::int32_t nearest = kNoise;
  float nearest_sq_distance = std::numeric_limits<float>::infinity();
  grid.ForEachWithin(point, epsilon_m, [&](std::int32_t neighbor, float sq_distance) {
    if (!is_core[neighbor] || sq_distance > nearest_sq_distance) return;
    if (sq_distance == nearest_sq_distance && neighbor > nearest) return;
    nearest = neighbor;
    nearest_sq_distance = sq_distance;
  });
  return nearest;
}

}  // namespace

std::vector<std::int32_t> Dbscan(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                 int min_points) {
  Check(points, epsilon_m, min_points);
  std::vector<std::int32_t> labels(points.size(), kNoise);
  if (points.empty()) return labels;

  const NeighborGrid grid(points, epsilon_m);
  const std::vector<std::uint8_t> is_core = FindCorePoints(grid, points, epsilon_m, min_points);
  std::int32_t cluster_count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_core[i] && labels[i] == kNoise)
      LabelConnectedCores(grid, points, is_core, epsilon_m, static_cast<std::int32_t>(i),
                          cluster_count++, labels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_core[i]) continue;
    const std::int32_t core = NearestCore(grid, points[i], is_core, epsilon_m);
    if (core != kNoise) labels[i] = labels[core];
  }
  return labels;
}

}  // namespace fallen
