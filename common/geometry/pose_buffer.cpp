// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/pose_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// Single precision senders round quaternions to 1e-7; 1e-3 still tells rounding from nonsense.
constexpr double kUnitLengthTolerance = 1e-3;

// Seconds from `earlier` to `later`; the unsigned difference is right where the signed one
// overflows.
double SecondsBetween(std::int64_t earlier, std::int64_t later) {
  return 1e-6 * static_cast<double>(static_cast<std::uint64_t>(later) -
                                    static_cast<std::uint64_t>(earlier));
}

void RequireDuration(const char* name, double seconds) {
  if (std::isfinite(seconds) && seconds >= 0) return;
  throw std::invalid_argument(std::string("pose_buffer: ") + name + " is " +
                              std::to_string(seconds) + ", must be >= 0 and finite");
}

Eigen::Isometry3d MakePose(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = translation;
  return pose;
}

}  // namespace

PoseBuffer::PoseBuffer(double max_gap_s, double max_extrapolation_s)
    : max_gap_s_(max_gap_s), max_extrapolation_s_(max_extrapolation_s) {
  RequireDuration("max_gap_s", max_gap_s);
  RequireDuration("max_extrapolation_s", max_extrapolation_s);
}

bool PoseBuffer::Add(std::int64_t utime, const Eigen::Vector3d& translation,
                     const Eigen::Quaterniond& rotation) {
  // A NaN or infinite coefficient makes the norm fail the comparison as well.
  if (!translation.allFinite() || !(std::abs(rotation.norm() - 1) <= kUnitLengthTolerance))
    return false;
  if (!entries_.empty() && utime < entries_.back().utime) entries_.clear();
  if (!entries_.empty() && utime == entries_.back().utime) entries_.pop_back();
  entries_.push_back({utime, translation, rotation.normalized()});
  if (entries_.size() > kCapacity) entries_.pop_front();
  return true;
}

std::optional<Eigen::Isometry3d> PoseBuffer::At(std::int64_t utime) const {
  const auto after =
      std::upper_bound(entries_.begin(), entries_.end(), utime,
                       [](std::int64_t time, const Entry& entry) { return time < entry.utime; });
  if (after == entries_.begin()) return std::nullopt;
  const Entry& earlier = *std::prev(after);
  const double age_s = SecondsBetween(earlier.utime, utime);
  if (after == entries_.end() || SecondsBetween(earlier.utime, after->utime) > max_gap_s_) {
    if (age_s > max_extrapolation_s_) return std::nullopt;
    return MakePose(earlier.translation, earlier.rotation);
  }
  const double t = age_s / SecondsBetween(earlier.utime, after->utime);
  return MakePose((1 - t) * earlier.translation + t * after->translation,
                  earlier.rotation.slerp(t, after->rotation));
}

std::optional<std::int64_t> PoseBuffer::newest_utime() const {
  if (entries_.empty()) return std::nullopt;
  return entries_.back().utime;
}

}  // namespace fallen
