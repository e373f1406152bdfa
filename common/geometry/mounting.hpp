// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace fallen {

/// Pose of a camera on the robot, from what one measures with a tape and a spirit level.
///
/// Robot frame: x forward, y left, z up from the floor. All angles zero: the camera looks forward,
/// level. Turned about its own axes: first yaw (positive looks left), then pitch (positive looks
/// down), then roll (positive tips to the right).
/// @param position_m              Camera in the robot frame [m].
/// @param roll_pitch_yaw_deg      [deg]
/// @return From the optical frame (x right, y down, z forward) to the robot.
Eigen::Isometry3d T_robot_cameraFromMounting(const std::array<double, 3>& position_m,
                                             const std::array<double, 3>& roll_pitch_yaw_deg);

}  // namespace fallen
