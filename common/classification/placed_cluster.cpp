// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "fallen/classification/cluster_feature_blocks.hpp"
#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

constexpr double kMinLength = 1e-3;  // [m]

// Direction in which the places spread most, and how far they spread along and across it.
struct MainAxis {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
  double deviation_along = 0;
  double deviation_across = 0;
};

MainAxis FindMainAxis(const std::vector<Eigen::Vector2d>& places) {
  MainAxis axis;
  for (const Eigen::Vector2d& place : places) axis.mean += place;
  const auto count = static_cast<double>(places.size());
  axis.mean /= count;
  double xx = 0, xy = 0, yy = 0;
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2d d = place - axis.mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double middle = (xx + yy) / 2;
  const double spread = std::hypot((xx - yy) / 2, xy);
  axis.deviation_along = std::sqrt((middle + spread) / count);
  axis.deviation_across = std::sqrt(std::max(middle - spread, 0.0) / count);
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  axis.direction = {std::cos(angle), std::sin(angle)};
  return axis;
}

}  // namespace

PlacedCluster::PlacedCluster(const ClusterScene& s, const CellCluster& c, const OrientedBox& b)
    : scene(s), cluster(c), box(b), frame(Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX()) {
  KeptVector<Eigen::Vector2d> places;
  places.reserve(cluster.cells.size());
  for (const std::int32_t i : cluster.cells)
    places.push_back(scene.segmented.cells[i].mean.head<2>().cast<double>());
  const MainAxis axis = FindMainAxis(places);
  deviation_along = axis.deviation_along;
  deviation_across = axis.deviation_across;

  const FloorFrame either_way(axis.mean, axis.direction);
  double height_sums[2] = {0, 0};
  int counts[2] = {0, 0};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const int half = either_way.Place(places[k]).x() > 0;
    height_sums[half] += scene.heights_m[cluster.cells[k]];
    ++counts[half];
  }
  const auto mean = [&](int half) { return counts[half] ? height_sums[half] / counts[half] : 0.0; };
  const bool is_backwards = mean(0) > mean(1);
  frame = FloorFrame(axis.mean, is_backwards ? Eigen::Vector2d(-axis.direction) : axis.direction);

  double greatest_along = 0;
  cells.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::Vector2d place = frame.Place(places[k]);
    const std::int32_t i = cluster.cells[k];
    cells.push_back({place.x(), place.y(), scene.heights_m[i], scene.segmented.cells[i].score});
    least_along = std::min(least_along, place.x());
    greatest_along = std::max(greatest_along, place.x());
  }
  length = std::max(greatest_along - least_along, kMinLength);
}

}  // namespace fallen
