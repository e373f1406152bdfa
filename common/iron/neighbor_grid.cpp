// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/neighbor_grid.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// Buckets that a grid may have per point, and at least: memory stays in proportion to the points,
// while a room of 6 x 6 x 2 m with 0.25 m buckets (4 608 of them) is never widened.
constexpr double kMaxBucketsPerPoint = 16;
constexpr double kMinBucketLimit = 65536;
// Farther out a float cannot tell points a hundred metres apart; differences still must not
// overflow.
constexpr float kMaxCoordinate = 1e9f;

}  // namespace

void NeighborGrid::Build(std::span<const Eigen::Vector3f> points, float bucket_m) {
  bucket_ = bucket_m;
  if (!(bucket_m > 0) || !std::isfinite(bucket_m))
    throw std::invalid_argument("neighbor_grid: bucket_m is " + std::to_string(bucket_m) +
                                ", must be > 0");
  sorted_points_.resize(points.size());
  sorted_index_.resize(points.size());
  if (points.empty()) {
    origin_ = last_ = Eigen::Array3f::Zero();
    size_ = Eigen::Vector3i::Ones();
    bucket_begin_.assign(2, 0);
    inverse_bucket_ = 1 / bucket_;
    return;
  }
  Eigen::Array3f low = points[0], high = points[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].cwiseAbs().maxCoeff() <= kMaxCoordinate) || !points[i].allFinite())
      throw std::invalid_argument("neighbor_grid: point " + std::to_string(i) +
                                  " is not finite or beyond 1e9 m");
    low = low.min(points[i].array());
    high = high.max(points[i].array());
  }
  origin_ = low;

  const double limit =
      std::max(kMinBucketLimit, kMaxBucketsPerPoint * static_cast<double>(points.size()));
  const Eigen::Array3d extent = high.cast<double>() - low.cast<double>();
  const auto bucket_count = [&] {
    return ((extent / static_cast<double>(bucket_)).floor() + 2).prod();
  };
  while (bucket_count() > limit) bucket_ *= 2;
  inverse_bucket_ = 1 / bucket_;
  last_ = ((high - origin_) * inverse_bucket_).floor();
  size_ = last_.cast<int>() + 1;

  // Counting sort by bucket; stable, so that the order depends on the points alone.
  bucket_of_.resize(points.size());
  bucket_begin_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3i b = Bucket(points[i].array());
    bucket_of_[i] = (b.z() * size_.y() + b.y()) * size_.x() + b.x();
    ++bucket_begin_[bucket_of_[i] + 1];
  }
  for (std::size_t b = 1; b < bucket_begin_.size(); ++b) bucket_begin_[b] += bucket_begin_[b - 1];
  next_.assign(bucket_begin_.begin(), bucket_begin_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t position = next_[bucket_of_[i]]++;
    sorted_points_[position] = points[i];
    sorted_index_[position] = static_cast<std::int32_t>(i);
  }
}

}  // namespace fallen
