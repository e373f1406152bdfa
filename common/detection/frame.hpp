// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "fallen/geometry/depth_image.hpp"

namespace fallen {

/// One picture as it enters the chain.
struct Frame {
  std::int64_t utime = 0;   ///< time of measurement [us]
  std::int64_t seq = 0;     ///< the source's count; results keep it
  std::string sensor_name;  ///< camera; results keep it
  DepthImage image;
  std::optional<Eigen::Isometry3d> T_robot_camera;  ///< mounting, z of the robot up from the floor
  std::optional<Eigen::Isometry3d> T_world_robot;   ///< pose at `utime`
};

/// Time spent in each stage [ms].
struct StageTimes {
  double ground = 0;
  double ndt = 0;
  double background = 0;
  double iron = 0;
  double cells = 0;
  double clusters = 0;  ///< finding and judging them
  double total = 0;
};

}  // namespace fallen
