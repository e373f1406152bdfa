// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fallen {

/// Fixed-radius neighbour search over points of one frame, by a voxel grid instead of a tree.
///
/// Found once a frame, used by descriptors, smoothing and clustering alike.
/// Copies the points. Points must be finite. Immutable after construction, so thread-safe.
class NeighborGrid {
 public:
  /// @param bucket_m  Edge of a grid cell [m], > 0; best near the radius that is searched most.
  NeighborGrid(std::span<const Eigen::Vector3f> points, float bucket_m);

  /// Calls `visit(index, squared_distance)` for every point within `radius_m` of `query`, itself
  /// included, in an order that depends only on the points.
  template <class Visit>
  void ForEachWithin(const Eigen::Vector3f& query, float radius_m, Visit&& visit) const {
    const float sq_radius = radius_m * radius_m;
    const Eigen::Vector3i low = Bucket(query.array() - radius_m);
    const Eigen::Vector3i high = Bucket(query.array() + radius_m);
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y) {
        // Buckets of one row are neighbours in memory: one run of points for the whole row.
        const std::int32_t row = (z * size_.y() + y) * size_.x();
        const std::int32_t end = bucket_begin_[row + high.x() + 1];
        for (std::int32_t k = bucket_begin_[row + low.x()]; k < end; ++k) {
          const float sq_distance = (sorted_points_[k] - query).squaredNorm();
          if (sq_distance <= sq_radius) visit(sorted_index_[k], sq_distance);
        }
      }
  }

  std::size_t size() const { return sorted_points_.size(); }

 private:
  Eigen::Vector3i Bucket(const Eigen::Array3f& p) const;  // clamped to the grid

  float inverse_bucket_ = 1;
  Eigen::Array3f origin_ = Eigen::Array3f::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Ones();
  std::vector<std::int32_t> bucket_begin_;
  std::vector<Eigen::Vector3f> sorted_points_;
  std::vector<std::int32_t> sorted_index_;
};

}  // namespace fallen
