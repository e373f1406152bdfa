// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fallen/geometry/ground_plane.hpp"
#include "synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::CameraPose;
using testing::kRadPerDeg;

Plane FloorSeenFrom(const Eigen::Isometry3d& T_world_camera) {
  return TransformPlane(T_world_camera.inverse(), Plane{});
}

TEST(CameraAttitude, HandWorkedExamples) {
  const CameraAttitude level = AttitudeOverGround({{0, -1, 0}, 1.2});
  EXPECT_EQ(level.height_m, 1.2);
  EXPECT_EQ(level.pitch_rad, 0);
  EXPECT_EQ(level.roll_rad, 0);
  // The floor's normal points at a camera that looks straight down.
  EXPECT_NEAR(AttitudeOverGround({{0, 0, -1}, 1}).pitch_rad, 90 * kRadPerDeg, 1e-12);
  // Image right points down: up is image left.
  EXPECT_NEAR(AttitudeOverGround({{-1, 0, 0}, 1}).roll_rad, 90 * kRadPerDeg, 1e-12);
}

TEST(CameraAttitude, IsThatOfTheCamerasPose) {
  for (const double pitch : {-20.0, 0.0, 4.0, 30.0, 80.0}) {
    for (const double roll : {-150.0, -10.0, 0.0, 45.0}) {
      const CameraAttitude attitude =
          AttitudeOverGround(FloorSeenFrom(CameraPose(0.7, pitch, roll)));
      EXPECT_NEAR(attitude.height_m, 0.7, 1e-12);
      EXPECT_NEAR(attitude.pitch_rad / kRadPerDeg, pitch, 1e-9);
      EXPECT_NEAR(attitude.roll_rad / kRadPerDeg, roll, 1e-9);
    }
  }
}

// A camera over the world's origin that looks along the world's x: level and world are the same.
TEST(LevelFrame, IsTheWorldUnderACameraThatLooksAlongX) {
  for (const double pitch : {-30.0, 0.0, 25.0, 85.0, 90.0, -90.0}) {
    for (const double roll : {-20.0, 0.0, 35.0}) {
      if (std::abs(pitch) == 90 && roll != 0) continue;  // heading is then by the image's up
      const Eigen::Isometry3d T_world_camera = CameraPose(1.3, pitch, roll);
      const Eigen::Isometry3d T_level_camera = LevelFrameFromGround(FloorSeenFrom(T_world_camera));
      EXPECT_TRUE(T_level_camera.isApprox(T_world_camera, 1e-7)) << pitch << " " << roll;
    }
  }
}

TEST(LevelFrame, IsARigidFrameWithTheFloorAtZero) {
  const Plane floor{Eigen::Vector3d(0.1, -0.9, -0.4).normalized(), 0.83};
  const Eigen::Isometry3d T_level_camera = LevelFrameFromGround(floor);
  const Eigen::Matrix3d R = T_level_camera.linear();
  EXPECT_TRUE((R * R.transpose()).isIdentity(1e-12));
  EXPECT_NEAR(R.determinant(), 1, 1e-12);
  const Plane level = TransformPlane(T_level_camera, floor);
  EXPECT_TRUE(level.normal.isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_NEAR(level.offset, 0, 1e-12);
  const Eigen::Vector3d forward = R * Eigen::Vector3d::UnitZ();
  EXPECT_GT(forward.x(), 0);
  EXPECT_NEAR(forward.y(), 0, 1e-12);
}

}  // namespace
}  // namespace fallen
