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
  NdtMap map;
  UpdateMap(mapper, frame, config, map, milliseconds);
  return map;
}

void UpdateMap(NdtMapper& mapper, const Frame& frame, const GroundConfig& config, NdtMap& map,
               StageTimes* milliseconds) {
  Stopwatch stopwatch;
  const GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera, config);
  const double ground_ms = stopwatch.LapMilliseconds();
  mapper.Update(frame.utime, frame.image, CameraPose(frame), ground, map);
  MakeCameraView(frame.image, map.view);
  const double ndt_ms = stopwatch.LapMilliseconds();
  if (milliseconds) {
    milliseconds->ground = ground_ms;
    milliseconds->ndt = ndt_ms;
  }
}

}  // namespace fallen
