// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace fallen {

/// A camera's pose as a robot on the floor that carries the camera.
struct RobotAndMounting {
  Eigen::Isometry3d T_world_robot;   ///< below the camera on z = 0, x along the viewing direction
  Eigen::Isometry3d T_robot_camera;  ///< the rest: height, pitch and roll
};

/// Splits the pose of a camera (optical frame; world z up) so that the product of the two parts is
/// the pose. Recordings with a hand-held camera then look like those of a robot.
/// A camera that looks straight up or down is taken to head where the top of its image points.
RobotAndMounting SplitCameraPose(const Eigen::Isometry3d& T_world_camera);

}  // namespace fallen
