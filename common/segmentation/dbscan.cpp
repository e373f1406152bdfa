// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/dbscan.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

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

void PointClusterer::FindCorePoints(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                    int min_points) {
  is_core_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    int count = 0;
    grid_.ForEachWithin(points[i], epsilon_m, [&](std::int32_t, float) { ++count; });
    is_core_[i] = count >= min_points;
  }
}

// Gives `cluster` to the core points that chains of core points, each within epsilon of the one
// before, connect with `seed`.
void PointClusterer::LabelConnectedCores(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                         std::int32_t seed, std::int32_t cluster) {
  open_.assign(1, seed);
  labels_[seed] = cluster;
  while (!open_.empty()) {
    const std::int32_t core = open_.back();
    open_.pop_back();
    grid_.ForEachWithin(points[core], epsilon_m, [&](std::int32_t neighbor, float) {
      if (!is_core_[neighbor] || labels_[neighbor] != kNoise) return;
      labels_[neighbor] = cluster;
      open_.push_back(neighbor);
    });
  }
}

const std::vector<std::int32_t>& PointClusterer::Label(std::span<const Eigen::Vector3f> points,
                                                       float epsilon_m, int min_points) {
  Check(points, epsilon_m, min_points);
  labels_.assign(points.size(), kNoise);
  if (points.empty()) return labels_;

  grid_.Build(points, epsilon_m);
  FindCorePoints(points, epsilon_m, min_points);
  std::int32_t cluster_count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_core_[i] && labels_[i] == kNoise)
      LabelConnectedCores(points, epsilon_m, static_cast<std::int32_t>(i), cluster_count++);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_core_[i]) continue;
    const std::int32_t core = NearestCore(grid_, points[i], is_core_, epsilon_m);
    if (core != kNoise) labels_[i] = labels_[core];
  }
  return labels_;
}

std::vector<std::int32_t> Dbscan(std::span<const Eigen::Vector3f> points, float epsilon_m,
                                 int min_points) {
  return PointClusterer().Label(points, epsilon_m, min_points);
}

}  // namespace fallen
