// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fallen {

/// Positions [begin, end) in the order of a NeighborGrid.
struct CellRun {
  std::int32_t begin;
  std::int32_t end;
};

/// A point and how far it is.
struct NearestPoint {
  std::int32_t index = -1;                                     ///< as the point was given; -1: none
  float sq_distance = std::numeric_limits<float>::infinity();  ///< [m^2]
};

/// Fixed-radius neighbour search over points of one frame, by a voxel grid instead of a tree.
///
/// Found once a frame, used by descriptors, smoothing and clustering alike.
/// Copies the points. Points must be finite. Thread-safe between calls of Build.
class NeighborGrid {
 public:
  /// A grid over nothing.
  NeighborGrid() : NeighborGrid({}, 1) {}

  /// @param bucket_m  Edge of a grid cell [m], > 0; best near half the radius that is searched
  /// most.
  ///                  Widened where the points lie so far apart that the grid would outgrow them.
  /// @throws std::invalid_argument if `bucket_m` is not positive, or a point is not finite or
  ///         beyond 1e9 m.
  NeighborGrid(std::span<const Eigen::Vector3f> points, float bucket_m) { Build(points, bucket_m); }

  /// Starts anew, in the memory that the grid already has: as the constructor.
  void Build(std::span<const Eigen::Vector3f> points, float bucket_m);

  /// Calls `visit(index, squared_distance)` for every point within `radius_m` of `query`, itself
  /// included, in an order that depends only on the points.
  template <class Visit>
  void ForEachWithin(const Eigen::Vector3f& query, float radius_m, Visit&& visit) const {
    const float sq_radius = radius_m * radius_m;
    ForEachRun(query, radius_m, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t k = begin; k < end; ++k) {
        const float sq_distance = (sorted_points_[k] - query).squaredNorm();
        if (sq_distance <= sq_radius) visit(sorted_index_[k], sq_distance);
      }
    });
  }

  /// Calls `visit(begin, end)` for runs of positions in `sorted_points()` that together hold every
  /// point within `radius_m` of `query`, and some farther ones: for callers that test whole runs.
  template <class Visit>
  void ForEachRun(const Eigen::Vector3f& query, float radius_m, Visit&& visit) const {
    ForEachRunNearBox(query, query, radius_m, visit);
  }

  /// Likewise for the points within `radius_m` of the box from `low` to `high`. Whatever the box, a
  /// point's neighbours come in one order.
  template <class Visit>
  void ForEachRunNearBox(const Eigen::Array3f& low, const Eigen::Array3f& high, float radius_m,
                         Visit&& visit) const {
    // What rounding may take from a distance is given back, so that no point on the rim is lost.
    const Eigen::Array3f reach = radius_m + 4 * std::numeric_limits<float>::epsilon() *
                                                (low.abs().max(high.abs()) + radius_m);
    const Eigen::Vector3i first = Bucket(low - reach), last = Bucket(high + reach);
    const Eigen::Vector3i first_inside = Bucket(low), last_inside = Bucket(high);
    const float sq_reach = reach.maxCoeff() * reach.maxCoeff();
    const float slack_x = reach.x() - radius_m;
    for (int z = first.z(); z <= last.z(); ++z) {
      const float dz = Gap(z, 2, first_inside.z(), last_inside.z(), low, high);
      for (int y = first.y(); y <= last.y(); ++y) {
        const float dy = Gap(y, 1, first_inside.y(), last_inside.y(), low, high);
        const float sq_left = sq_reach - (dy * dy + dz * dz);
        if (sq_left < 0) continue;
        // Buckets of one row are neighbours in memory: one run of points for the whole row, as far
        // as the rounded box reaches along it.
        const float reach_x = std::sqrt(sq_left) + slack_x;
        const int low_x = BucketX(low.x() - reach_x);
        const int high_x = BucketX(high.x() + reach_x);
        const std::int32_t row = (z * size_.y() + y) * size_.x();
        const std::int32_t begin = bucket_begin_[row + low_x];
        const std::int32_t end = bucket_begin_[row + high_x + 1];
        if (begin < end) visit(begin, end);
      }
    }
  }

  /// The point nearest to `query`, no farther than `radius_m`; of several as near, the one of the
  /// smallest index. Quick where a point lies close by: only the buckets that could hold a nearer
  /// one are looked at.
  /// @param enough_m  A point nearer than this will do, nearest or not.
  NearestPoint FindNearest(const Eigen::Vector3f& query, float radius_m, double enough_m = 0) const;

  std::size_t size() const { return sorted_points_.size(); }
  std::span<const Eigen::Vector3f> sorted_points() const { return sorted_points_; }
  /// Index that the point at a position of `sorted_points()` was given with.
  std::span<const std::int32_t> sorted_index() const { return sorted_index_; }

 private:
  Eigen::Vector3i Bucket(const Eigen::Array3f& p) const {  // clamped to the grid
    const Eigen::Array3f scaled = (p - origin_) * inverse_bucket_;
    return scaled.max(0.0f).min(last_).cast<int>();  // not negative: rounds down
  }

  int BucketX(float x) const {
    const float scaled = (x - origin_.x()) * inverse_bucket_;
    return static_cast<int>(std::min(std::max(scaled, 0.0f), last_.x()));
  }

  // At most the distance along one axis from the box to the points of bucket `index` [m].
  float Gap(int index, int axis, int first_inside, int last_inside, const Eigen::Array3f& low,
            const Eigen::Array3f& high) const {
    if (index >= first_inside && index <= last_inside) return 0;
    const bool above = index > last_inside;
    const float side = above ? high[axis] : low[axis];
    const float edge = origin_[axis] + static_cast<float>(above ? index : index + 1) * bucket_;
    // Buckets are found by multiplication, their edges here by another: leave room for rounding.
    const float gap = above ? edge - side : side - edge;
    const float slack = 4 * std::numeric_limits<float>::epsilon() *
                        (std::abs(edge) + std::abs(side) + std::abs(origin_[axis]));
    return gap > slack ? gap - slack : 0;
  }

  float bucket_ = 1;
  float inverse_bucket_ = 1;
  Eigen::Array3f origin_ = Eigen::Array3f::Zero();
  Eigen::Array3f last_ = Eigen::Array3f::Zero();  // index of the last bucket
  Eigen::Vector3i size_ = Eigen::Vector3i::Ones();
  std::vector<std::int32_t> bucket_begin_;
  std::vector<Eigen::Vector3f> sorted_points_;
  std::vector<std::int32_t> sorted_index_;
  std::vector<std::int32_t> bucket_of_, next_;  // of Build
};

}  // namespace fallen
