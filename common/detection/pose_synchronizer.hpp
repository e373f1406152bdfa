// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "fallen/detection/frame.hpp"
#include "fallen/geometry/pose_buffer.hpp"

namespace fallen {

struct PoseSynchronizerConfig {
  /// Longest time, by the frames' own clock, that a frame waits for the pose after it [s], >= 0.
  /// Poses at 10 Hz, the slowest that are of use for a moving robot, are 0.1 s apart.
  double max_wait_s = 0.15;
  /// More frames than this never wait, >= 0: 0.15 s at 30 Hz and one more.
  std::size_t max_waiting_frames = 5;
  /// Two poses farther apart than this are not interpolated between; poses that stay away for
  /// longer are not waited for [s], > 0.
  double max_gap_s = 0.5;
  /// How far the newest pose speaks beyond its time [s], >= 0.
  double max_extrapolation_s = 0.1;

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
};

/// Joins frames with the robot's pose at their time.
///
/// Takes poses and frames in the order in which they arrive and returns the frames, in order, as
/// soon as their pose is settled: at once if a pose at or after the frame's time is known, if no
/// pose has come so far, or if poses have stopped; else with the next pose, or when later frames
/// show that waiting is over. A frame without a pose near enough comes out without one.
///
/// A pure function of the sequence of calls, so that a live service and a tool that reads a log
/// give the same frames the same poses. Not thread-safe.
class PoseSynchronizer {
 public:
  /// @throws std::invalid_argument if `config` is out of range.
  explicit PoseSynchronizer(const PoseSynchronizerConfig& config = {});

  /// Takes a pose; returns the frames that it settles. A pose that PoseBuffer refuses is counted.
  std::vector<Frame> AddPose(std::int64_t utime, const Eigen::Vector3d& translation,
                             const Eigen::Quaterniond& rotation);

  /// Takes a frame, whose `T_world_robot` is overwritten; returns the frames that are settled now.
  std::vector<Frame> AddFrame(Frame frame);

  /// Returns all frames that still wait: at the end of a log, or when nothing comes any more.
  std::vector<Frame> Flush();

  std::size_t waiting() const { return waiting_.size(); }
  std::int64_t refused_poses() const { return refused_poses_; }

 private:
  bool IsSettled(const Frame& frame) const;
  void EmitFirst(std::vector<Frame>& emitted);

  PoseSynchronizerConfig config_;
  PoseBuffer poses_;
  std::deque<Frame> waiting_;
  std::optional<std::int64_t> newest_frame_utime_;
  std::int64_t refused_poses_ = 0;
};

}  // namespace fallen
