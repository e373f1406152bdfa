// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/pose_synchronizer.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace fallen {
namespace {

void RequireDuration(const char* name, double value, bool zero_allowed) {
  if (std::isfinite(value) && (value > 0 || (zero_allowed && value == 0))) return;
  throw std::invalid_argument(std::string("pose_synchronizer: ") + name + " is " +
                              std::to_string(value) + ", must be " +
                              (zero_allowed ? ">= 0" : "> 0"));
}

const PoseSynchronizerConfig& Validated(const PoseSynchronizerConfig& config) {
  config.Validate();
  return config;
}

/// True if `a` lies at least `duration_s` after `b`; whole microseconds, and no overflow for
/// whatever times a message claims.
bool IsAfterBy(std::int64_t a, std::int64_t b, double duration_s) {
  return static_cast<double>(a) - static_cast<double>(b) >= std::round(duration_s * 1e6);
}

}  // namespace

void PoseSynchronizerConfig::Validate() const {
  RequireDuration("max_wait_s", max_wait_s, true);
  RequireDuration("max_gap_s", max_gap_s, false);
  RequireDuration("max_extrapolation_s", max_extrapolation_s, true);
}

PoseSynchronizer::PoseSynchronizer(const PoseSynchronizerConfig& config)
    : config_(Validated(config)), poses_(config.max_gap_s, config.max_extrapolation_s) {}

bool PoseSynchronizer::IsSettled(const Frame& frame) const {
  const std::optional<std::int64_t> newest_pose = poses_.newest_utime();
  if (!newest_pose || *newest_pose >= frame.utime) return true;
  if (IsAfterBy(frame.utime, *newest_pose, config_.max_gap_s)) return true;
  return IsAfterBy(*newest_frame_utime_, frame.utime, config_.max_wait_s);
}

void PoseSynchronizer::EmitFirst(std::vector<Frame>& emitted) {
  Frame& first = waiting_.front();
  first.T_world_robot = poses_.At(first.utime);
  emitted.push_back(std::move(first));
  waiting_.pop_front();
}

std::vector<Frame> PoseSynchronizer::AddPose(std::int64_t utime, const Eigen::Vector3d& translation,
                                             const Eigen::Quaterniond& rotation) {
  std::vector<Frame> emitted;
  // A clock that ran back is about to empty the buffer: who waits is of the old time.
  const std::optional<std::int64_t> newest_pose = poses_.newest_utime();
  if (newest_pose && utime < *newest_pose) emitted = Flush();
  if (!poses_.Add(utime, translation, rotation)) ++refused_poses_;
  while (!waiting_.empty() && IsSettled(waiting_.front())) EmitFirst(emitted);
  return emitted;
}

std::vector<Frame> PoseSynchronizer::AddFrame(Frame frame) {
  std::vector<Frame> emitted;
  if (newest_frame_utime_ && frame.utime < *newest_frame_utime_) emitted = Flush();
  newest_frame_utime_ = frame.utime;
  waiting_.push_back(std::move(frame));
  while (!waiting_.empty() &&
         (waiting_.size() > config_.max_waiting_frames || IsSettled(waiting_.front())))
    EmitFirst(emitted);
  return emitted;
}

std::vector<Frame> PoseSynchronizer::Flush() {
  std::vector<Frame> emitted;
  while (!waiting_.empty()) EmitFirst(emitted);
  return emitted;
}

}  // namespace fallen
