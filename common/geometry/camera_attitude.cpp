// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "fallen/geometry/ground_plane.hpp"

namespace fallen {
namespace {

// Below this length the view direction's share along the floor is rounding, not a direction.
constexpr double kSmallestHeading = 1e-9;

// The camera's view direction laid onto the floor; for a camera that looks straight down or up, the
// direction that it would look in if it were raised or lowered: its image's up or down.
Eigen::Vector3d HeadingAlongFloor(const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d heading = forward - up.dot(forward) * up;
  if (heading.norm() > kSmallestHeading) return heading.normalized();
  const Eigen::Vector3d image_down = Eigen::Vector3d::UnitY();
  return up.z() < 0 ? Eigen::Vector3d(-image_down) : image_down;
}

}  // namespace

CameraAttitude AttitudeOverGround(const Plane& ground_camera) {
  const Eigen::Vector3d& up = ground_camera.normal;
  return {ground_camera.offset, std::asin(std::clamp(-up.z(), -1.0, 1.0)),
          std::atan2(-up.x(), -up.y())};
}

Eigen::Isometry3d LevelFrameFromGround(const Plane& ground_camera) {
  const Eigen::Vector3d up = ground_camera.normal.normalized();
  const Eigen::Vector3d ahead = HeadingAlongFloor(up);
  const Eigen::Vector3d left = up.cross(ahead);
  Eigen::Isometry3d T_level_camera = Eigen::Isometry3d::Identity();
  T_level_camera.linear().row(0) = ahead.transpose();
  T_level_camera.linear().row(1) = left.transpose();
  T_level_camera.linear().row(2) = up.transpose();
  T_level_camera.translation() = Eigen::Vector3d(0, 0, ground_camera.offset);
  return T_level_camera;
}

}  // namespace fallen
