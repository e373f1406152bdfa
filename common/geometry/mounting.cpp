// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/mounting.hpp"

#include <numbers>

namespace fallen {

Eigen::Isometry3d T_robot_cameraFromMounting(const std::array<double, 3>& position_m,
                                             const std::array<double, 3>& roll_pitch_yaw_deg) {
  const auto turn = [](double angle_deg, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180.0, axis);
  };
  Eigen::Matrix3d R_level_optical;  // forward is z of the optical frame, left is -x, up is -y
  R_level_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T_robot_camera = Eigen::Isometry3d::Identity();
  T_robot_camera.translation() = Eigen::Vector3d(position_m[0], position_m[1], position_m[2]);
  T_robot_camera.linear() = turn(roll_pitch_yaw_deg[2], Eigen::Vector3d::UnitZ()) *
                            turn(roll_pitch_yaw_deg[1], Eigen::Vector3d::UnitY()) *
                            turn(roll_pitch_yaw_deg[0], Eigen::Vector3d::UnitX()) * R_level_optical;
  return T_robot_camera;
}

}  // namespace fallen
