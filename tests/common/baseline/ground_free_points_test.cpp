// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/ground_free_points.hpp"

#include <gtest/gtest.h>

#include "fallen/geometry/ground_plane.hpp"
#include "tests/tools/common/lying_scene.hpp"

namespace fallen {
namespace {

Plane GroundOf(const Frame& frame) {
  return EstimateGround(frame.image, frame.T_robot_camera, {.method = GroundMethod::kMounting})
      .plane;
}

TEST(GroundFreePoints, LeaveTheFloorAndWhatIsTooHighAway) {
  BaselineConfig config;
  config.max_height_m = 0.5;
  const Frame frame = lying_scene::Render(0, 0, lying_scene::With::kPerson);
  const auto points = GroundFreePoints(frame.image, GroundOf(frame), config);
  OrientedBox block = lying_scene::Person();
  block.size.array() += 0.02;  // the depth image is in millimetres
  int of_block = 0, of_wall = 0;
  for (const Eigen::Vector3f& p : points) {
    EXPECT_GE(p.z(), config.ground_clearance_m);
    EXPECT_LE(p.z(), config.max_height_m);
    // The level frame is the world here: the robot stands at the origin and looks along x.
    if (block.Contains(p.cast<double>())) ++of_block;
    if (std::abs(p.x() - 3.5F) < 0.02F) ++of_wall;
  }
  EXPECT_EQ(of_block + of_wall, static_cast<int>(points.size()));
  EXPECT_GT(of_block, 1000);
  EXPECT_GT(of_wall, 1000);
}

TEST(GroundFreePoints, EndAtTheRangeAndBeginAboveTheGrowingClearance) {
  const Frame frame = lying_scene::Render(0, 0, lying_scene::With::kPerson);
  BaselineConfig config;
  config.max_range_m = 2.5;
  config.ground_clearance_per_sq_m = 0.05;
  const Eigen::Isometry3f T_camera_level =
      LevelFrameFromGround(GroundOf(frame)).inverse().cast<float>();
  const auto points = GroundFreePoints(frame.image, GroundOf(frame), config);
  EXPECT_GT(points.size(), 100u);
  for (const Eigen::Vector3f& p : points) {
    const float depth_m = (T_camera_level * p).z();
    EXPECT_LE(depth_m, 2.5F + 1e-4F);
    EXPECT_GE(p.z(), 0.04F + 0.05F * depth_m * depth_m - 1e-4F);
  }
}

TEST(GroundFreePoints, RefusesAMalformedImage) {
  Frame frame = lying_scene::Render(0, 0, lying_scene::With::kNobody);
  const Plane ground = GroundOf(frame);
  frame.image.depth.pop_back();
  EXPECT_THROW(GroundFreePoints(frame.image, ground, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
