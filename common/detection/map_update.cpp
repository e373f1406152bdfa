// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/map_update.hpp"

#include <optional>

#include "fallen/detection/stopwatch.hpp"

namespace fallen {
namespace {

std::optional<Eigen::Isometry3d> CameraPose(const Frame& frame) {
  if (!frame.T_world_robot || !frame.T_robot_camera) return std::nullopt;
  return *frame.T_world_robot * *frame.T_robot_camera;
}

}  // namespace

NdtMap UpdateMap(NdtMapper& mapper, const Frame& frame, const GroundConfig& config,
                 StageTimes* milliseconds) {
  Stopwatch stopwatch;
  const GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera, config);
  const double ground_ms = stopwatch.LapMilliseconds();
  NdtMap map = mapper.Update(frame.utime, frame.image, CameraPose(frame), ground);
  map.view = MakeCameraView(frame.image);
  const double ndt_ms = stopwatch.LapMilliseconds();
  if (milliseconds) {
    milliseconds->ground = ground_ms;
    milliseconds->ndt = ndt_ms;
  }
  return map;
}

}  // namespace fallen
