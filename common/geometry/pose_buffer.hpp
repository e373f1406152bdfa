// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace fallen {

/// Recent robot poses, for the pose at the time at which an image was taken.
class PoseBuffer {
 public:
  /// @param max_gap_s        Two poses farther apart than this are not interpolated between [s].
  /// @param max_extrapolation_s  A newest pose older than this does not speak for an image [s].
  /// @throws std::invalid_argument if one is negative or not finite.
  explicit PoseBuffer(double max_gap_s = 0.5, double max_extrapolation_s = 0.1);

  /// Adds a pose. A pose older than the newest (a clock that ran back) empties the buffer first;
  /// one of the same time replaces it; one with non-finite values or a quaternion that is not of
  /// unit length is refused.
  /// @return false if refused.
  bool Add(std::int64_t utime, const Eigen::Vector3d& translation,
           const Eigen::Quaterniond& rotation);

  /// Pose at `utime`: linear in translation, slerp in rotation. After the newest pose, and in a gap
  /// that is too long, the pose before `utime` is held for `max_extrapolation_s`, so that a replay
  /// gives what the live run gave. Nothing if no pose is near enough, and before the oldest.
  std::optional<Eigen::Isometry3d> At(std::int64_t utime) const;

  /// Time of the newest pose, if any.
  std::optional<std::int64_t> newest_utime() const;

 private:
  struct Entry {
    std::int64_t utime;
    Eigen::Vector3d translation;
    Eigen::Quaterniond rotation;
  };
  static constexpr std::size_t kCapacity = 1024;  // 10 s at 100 Hz
  double max_gap_s_;
  double max_extrapolation_s_;
  std::deque<Entry> entries_;
};

}  // namespace fallen
