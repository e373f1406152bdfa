// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/camera_pose_split.hpp"

#include <cmath>

namespace fallen {
namespace {

/// Horizontal share of the viewing direction below which it has no heading: half a degree.
constexpr double kMinHorizontal = 0.01;

double Heading(const Eigen::Matrix3d& R_world_camera) {
  const Eigen::Vector3d forward = R_world_camera.col(2);
  if (forward.head<2>().norm() >= kMinHorizontal) return std::atan2(forward.y(), forward.x());
  const Eigen::Vector3d image_top = -R_world_camera.col(1);
  return std::atan2(image_top.y(), image_top.x());
}

}  // namespace

RobotAndMounting SplitCameraPose(const Eigen::Isometry3d& T_world_camera) {
  const Eigen::Vector3d position = T_world_camera.translation();
  RobotAndMounting split;
  split.T_world_robot =
      Eigen::Translation3d(position.x(), position.y(), 0) *
      Eigen::AngleAxisd(Heading(T_world_camera.linear()), Eigen::Vector3d::UnitZ());
  split.T_robot_camera = split.T_world_robot.inverse() * T_world_camera;
  return split;
}

}  // namespace fallen
