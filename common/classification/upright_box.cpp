// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fallen/classification/hypothesis_selection.hpp"
#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

using Points2 = KeptVector<Eigen::Vector2d>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Finds the corners counter-clockwise, by Andrew's monotone chain; one point if all are the same,
// two if all lie on a line. Sorts the points.
void FindConvexHull(Points2& points, Points2& hull) {
  const auto is_less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), is_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    hull.assign(points.begin(), points.end());
    return;
  }
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t bottom = hull.size() + 1;
    for (auto point = begin; point != end; ++point) {
      while (hull.size() > bottom &&
             Cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // the first of the next chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
}

struct Rectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  // along x_axis, across it
  Eigen::Vector2d x_axis = Eigen::Vector2d::UnitX();
};

Rectangle RectangleAlong(const Eigen::Vector2d& x_axis, const Points2& hull, double margin) {
  const Eigen::Vector2d y_axis(-x_axis.y(), x_axis.x());
  Eigen::Vector2d low(x_axis.dot(hull[0]), y_axis.dot(hull[0]));
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& point : hull) {
    const Eigen::Vector2d turned(x_axis.dot(point), y_axis.dot(point));
    low = low.cwiseMin(turned);
    high = high.cwiseMax(turned);
  }
  const Eigen::Vector2d middle = (low + high) / 2;
  return {middle.x() * x_axis + middle.y() * y_axis, (high - low).array() + 2 * margin, x_axis};
}

// One side of the smallest rectangle lies along a side of the hull [Freeman75]: try them all.
Rectangle SmallestRectangle(const Points2& hull, double margin) {
  Rectangle smallest = RectangleAlong(Eigen::Vector2d::UnitX(), hull, margin);
  if (hull.size() < 2) return smallest;
  double smallest_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d side = hull[(i + 1) % hull.size()] - hull[i];
    const Rectangle rectangle = RectangleAlong(side.normalized(), hull, margin);
    if (rectangle.size.prod() >= smallest_area) continue;
    smallest = rectangle;
    smallest_area = rectangle.size.prod();
  }
  return smallest;
}

}  // namespace

OrientedBox FitUprightBox(const SegmentedMap& segmented, const CellCluster& cluster) {
  KeptVector<Eigen::Vector3d> means;
  means.reserve(cluster.cells.size());
  for (const std::int32_t index : cluster.cells)
    means.push_back(segmented.cells[index].mean.cast<double>());
  return FitUprightBox(means, segmented.cell_size_m / 2);
}

OrientedBox FitUprightBox(std::span<const Eigen::Vector3d> points, double margin) {
  if (points.empty())
    throw std::invalid_argument("cluster_classification: the cluster has no cells");
  double low = points[0].z();
  double high = low;
  Points2 ground, hull;
  ground.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    ground.push_back(point.head<2>());
    low = std::min(low, point.z());
    high = std::max(high, point.z());
  }
  FindConvexHull(ground, hull);
  Rectangle rectangle = SmallestRectangle(hull, margin);
  if (rectangle.size.x() < rectangle.size.y()) {
    rectangle.size = rectangle.size.reverse().eval();
    rectangle.x_axis = {-rectangle.x_axis.y(), rectangle.x_axis.x()};
  }
  // An axis has no sign: the half turn in which x is positive, or y is where x is zero.
  if (rectangle.x_axis.x() < 0 || (rectangle.x_axis.x() == 0 && rectangle.x_axis.y() < 0))
    rectangle.x_axis = -rectangle.x_axis;

  OrientedBox box;
  box.center << rectangle.center, (low + high) / 2;
  box.size << rectangle.size, high - low + 2 * margin;
  box.yaw = std::atan2(rectangle.x_axis.y(), rectangle.x_axis.x());
  return box;
}

}  // namespace fallen
