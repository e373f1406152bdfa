// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "fallen/geometry/camera_view.hpp"
#include "fallen/geometry/enum_names.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// What the map's coordinates refer to.
enum class MapFrame : std::int32_t {
  kWorld = 0,   ///< the frame of the robot's pose: comparable with an environment map
  kLevel = 1,   ///< LevelFrameFromGround: below the camera, z up; no pose was known
  kCamera = 2,  ///< camera frame: neither a pose nor a floor was known
};
constexpr auto EnumNames(MapFrame) {
  return EnumTable<MapFrame, 3>{
      {{MapFrame::kWorld, "world"}, {MapFrame::kLevel, "level"}, {MapFrame::kCamera, "camera"}}};
}

/// A local NDT map as one frame leaves it: what the stages after the mapping work on.
struct NdtMap {
  double cell_size_m = 0.05;
  MapFrame frame = MapFrame::kCamera;
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  CameraView view;        ///< what the newest frame could see; UpdateMap sets it
  GroundEstimate ground;  ///< plane in the map frame; only with `ground.ok()` is it free of floor
  std::vector<NdtCell> cells;  ///< ground-free, order deterministic
};

}  // namespace fallen
