// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/map_recording.hpp"

#include <stdexcept>
#include <utility>

#include "tools/common/progress_bar.hpp"
#include "tools/map/person_mask.hpp"

namespace fallen {
namespace {

/// How far from the camera cells are kept [m]: beyond every building.
constexpr double kExtentM = 1000;
/// Longest pause within a recording [s]: a day.
constexpr double kMaxTimeGapS = 86400;

NdtConfig Unbounded(NdtConfig config) {
  config.accumulate = true;
  config.extent_m = kExtentM;
  config.max_time_gap_s = kMaxTimeGapS;
  return config;
}

std::optional<Eigen::Isometry3d> CameraPose(const Frame& frame) {
  if (!frame.T_world_robot || !frame.T_robot_camera) return std::nullopt;
  return *frame.T_world_robot * *frame.T_robot_camera;
}

GroundEstimate FindFloor(const Frame& frame, const Eigen::Isometry3d& T_world_camera,
                         const GroundConfig& config) {
  GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera, config);
  if (ground.ok()) return ground;
  ground.status = GroundStatus::kOk;
  ground.method = GroundMethod::kMounting;
  ground.plane = TransformPlane(T_world_camera.inverse(), Plane{});
  return ground;
}

}  // namespace

RecordingMap MapRecording(FrameSource& recording, const GroundConfig& ground, const NdtConfig& ndt,
                          const std::string& name) {
  NdtMapper mapper(Unbounded(ndt));
  RecordingMap result;
  ProgressBar progress("map");
  while (std::optional<Frame> frame = recording.Next()) {
    const std::optional<Eigen::Isometry3d> T_world_camera = CameraPose(*frame);
    if (!T_world_camera) {
      ++result.without_pose;
      continue;
    }
    if (const std::optional<GroundTruth> truth = recording.Truth(*frame))
      RemovePersons(frame->image, *truth, *T_world_camera);
    const GroundEstimate floor = FindFloor(*frame, *T_world_camera, ground);
    result.cells = mapper.Update(frame->utime, frame->image, *T_world_camera, floor).cells;
    ++result.frames;
    progress.Update(recording.share_done(), std::to_string(result.cells.size()) + " cells");
  }
  result.damaged = recording.damage().count;
  if (result.frames == 0)
    throw std::runtime_error(name + ": got " + std::to_string(result.without_pose) +
                             " frames without a pose and mounting, expected poses of the robot: "
                             "a map needs to know where the camera is in the world");
  return result;
}

}  // namespace fallen
