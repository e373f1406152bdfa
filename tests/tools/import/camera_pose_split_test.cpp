// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/camera_pose_split.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace fallen {
namespace {

constexpr double kTolerance = 1e-12;  // rounding of a few products of numbers near 1

/// Camera at `position` that heads `yaw` and looks down by `pitch`.
Eigen::Isometry3d CameraAt(const Eigen::Vector3d& position, double yaw, double pitch) {
  Eigen::Matrix3d R_body_camera;  // x ahead, y left, z up <- x right, y down, z ahead
  R_body_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()))
                   .toRotationMatrix() *
               R_body_camera;
  T.translation() = position;
  return T;
}

TEST(SplitCameraPose, PutsTheRobotOnTheFloorBelowTheCameraAndHeadsWhereItLooks) {
  const RobotAndMounting split = SplitCameraPose(CameraAt({1, 2, 1.1}, 0.7, 0.3));
  const Eigen::Isometry3d expected_robot =
      Eigen::Translation3d(1, 2, 0) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(split.T_world_robot.isApprox(expected_robot, kTolerance));
  EXPECT_TRUE(split.T_robot_camera.isApprox(CameraAt({0, 0, 1.1}, 0, 0.3), kTolerance));
}

TEST(SplitCameraPose, PartsMultiplyToThePose) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    T_world_camera.linear() = Eigen::Quaterniond(normal(generator), normal(generator),
                                                 normal(generator), normal(generator))
                                  .normalized()
                                  .toRotationMatrix();
    T_world_camera.translation() << normal(generator), normal(generator), normal(generator);
    const RobotAndMounting split = SplitCameraPose(T_world_camera);
    EXPECT_TRUE((split.T_world_robot * split.T_robot_camera).isApprox(T_world_camera, kTolerance));
    EXPECT_EQ(split.T_world_robot.translation().z(), 0);
    EXPECT_TRUE(split.T_world_robot.linear().col(2).isApprox(Eigen::Vector3d::UnitZ(), kTolerance));
  }
}

TEST(SplitCameraPose, ACameraThatLooksStraightDownHeadsWhereItsImageHasItsTop) {
  const RobotAndMounting split = SplitCameraPose(CameraAt({0, 0, 2}, -0.4, std::numbers::pi / 2));
  const Eigen::Vector3d heading = split.T_world_robot.linear().col(0);
  EXPECT_NEAR(std::atan2(heading.y(), heading.x()), -0.4, 1e-9);
}

}  // namespace
}  // namespace fallen
