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

NearestPoint NeighborGrid::FindNearest(const Eigen::Vector3f& query, float radius_m,
                                       double enough_m) const {
  NearestPoint nearest;
  nearest.sq_distance = radius_m * radius_m;
  const auto look_at = [&](std::int32_t begin, std::int32_t end) {
    for (std::int32_t k = begin; k < end; ++k) {
      const float sq_distance = (sorted_points_[k] - query).squaredNorm();
      if (sq_distance > nearest.sq_distance) continue;
      const bool as_near = nearest.index >= 0 && sq_distance == nearest.sq_distance;
      if (as_near && sorted_index_[k] > nearest.index) continue;
      nearest = {sorted_index_[k], sq_distance};
    }
  };
  const Eigen::Vector3i own = Bucket(query.array());
  const std::int32_t bucket = (own.z() * size_.y() + own.y()) * size_.x() + own.x();
  // Less a little, so that what is enough here is so by its root too.
  const auto sq_enough = static_cast<float>(enough_m * enough_m * (1 - 1e-6));
  for (std::int32_t k = bucket_begin_[bucket]; k < bucket_begin_[bucket + 1]; ++k) {
    const float sq_distance = (sorted_points_[k] - query).squaredNorm();
    if (sq_distance < sq_enough && sq_distance <= nearest.sq_distance)
      return {sorted_index_[k], sq_distance};
  }
  look_at(bucket_begin_[bucket], bucket_begin_[bucket + 1]);

  // Nearer points lie within this distance, most often within the same bucket. What rounding may
  // take from a distance is given back.
  const float left = nearest.index >= 0 ? std::sqrt(nearest.sq_distance) : radius_m;
  const Eigen::Array3f reach =
      left + 4 * std::numeric_limits<float>::epsilon() * (query.array().abs() + radius_m);
  const Eigen::Vector3i first = Bucket(query.array() - reach), last = Bucket(query.array() + reach);
  if (first != last)
    for (int z = first.z(); z <= last.z(); ++z)
      for (int y = first.y(); y <= last.y(); ++y) {
        const std::int32_t row = (z * size_.y() + y) * size_.x();
        look_at(bucket_begin_[row + first.x()], bucket_begin_[row + last.x() + 1]);
      }
  if (nearest.index < 0) nearest = {};
  return nearest;
}

}  // namespace fallen
