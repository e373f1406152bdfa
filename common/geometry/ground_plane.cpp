// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_plane.hpp"

#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr double kRotationTolerance = 1e-6;  // a mounting in YAML carries six digits or more

void ValidateMounting(const Eigen::Isometry3d& T_robot_camera) {
  const Eigen::Matrix3d& R = T_robot_camera.linear();
  if (!T_robot_camera.matrix().allFinite() || R.determinant() < 0 ||
      !(R * R.transpose()).isIdentity(kRotationTolerance))
    throw std::invalid_argument("ground: T_robot_camera must be finite, with a rotation matrix");
  if (T_robot_camera.translation().z() <= 0)
    throw std::invalid_argument("ground: T_robot_camera has the camera at height " +
                                std::to_string(T_robot_camera.translation().z()) +
                                " m, must be above the floor, z = 0");
}

// The robot's plane z = 0 seen from the camera.
GroundEstimate GroundFromMounting(const Eigen::Isometry3d& T_robot_camera) {
  GroundEstimate estimate;
  estimate.status = GroundStatus::kOk;
  estimate.method = GroundMethod::kMounting;
  estimate.plane.normal = T_robot_camera.linear().row(2).transpose();
  estimate.plane.offset = T_robot_camera.translation().z();
  return estimate;
}

}  // namespace

GroundEstimate EstimateGround(const DepthImage& image,
                              const std::optional<Eigen::Isometry3d>& T_robot_camera,
                              const GroundConfig& config) {
  image.Validate();
  config.Validate();
  if (T_robot_camera) ValidateMounting(*T_robot_camera);
  if (T_robot_camera) return GroundFromMounting(*T_robot_camera);
  GroundEstimate none;
  none.status = GroundStatus::kNoMounting;
  return none;
}

}  // namespace fallen
