// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/robot_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fallen::sim {
namespace {

ColumnGrid RoomWithPillar() {
  ColumnGrid grid({5, 4});
  TriangleMesh pillar = MakeBox({0.5, 0.5, 2});
  pillar.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 1)));
  grid.Add(pillar);
  return grid;
}

TEST(RobotPath, KeepsSpeedTurnAndDistance) {
  const ColumnGrid grid = RoomWithPillar();
  PathConfig config;
  config.frames = 100;
  for (int seed = 1; seed <= 10; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto path = DrawPath(config, grid, {5, 4}, std::nullopt, random);
    ASSERT_EQ(path.size(), 100u);
    for (std::size_t i = 0; i < path.size(); ++i) {
      // 5 cm cells: the radius is kept up to one of them.
      const double dx = std::max(0.0, std::abs(path[i].x) - 0.25),
                   dy = std::max(0.0, std::abs(path[i].y) - 0.25);
      EXPECT_GT(std::hypot(dx, dy), config.robot_radius_m - 0.08);
      EXPECT_LT(std::abs(path[i].x), 2.5 - config.robot_radius_m + 0.06);
      EXPECT_LT(std::abs(path[i].y), 2.0 - config.robot_radius_m + 0.06);
      if (i == 0) continue;
      const double moved = std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
      EXPECT_LE(moved, config.max_speed_m_s / config.rate_hz + 1e-9);
      const double turned = std::remainder(path[i].yaw - path[i - 1].yaw, 2 * M_PI);
      EXPECT_LE(std::abs(turned), config.max_turn_rad_s / config.rate_hz + 1e-9);
      // Wheels do not slip sideways.
      if (moved > 1e-6) {
        EXPECT_NEAR(
            std::remainder(
                std::atan2(path[i].y - path[i - 1].y, path[i].x - path[i - 1].x) - path[i].yaw,
                2 * M_PI),
            0, 1e-6);
      }
    }
  }
}

TEST(RobotPath, HasItsTargetInViewForMostOfTheDrive) {
  ColumnGrid grid({5, 4});
  const Eigen::Vector2d target(1, 0.5);
  PathConfig config;
  Random random(3);
  const auto path = DrawPath(config, grid, {5, 4}, target, random);
  int in_view = 0;
  for (const RobotPose& pose : path) {
    const double bearing = std::atan2(target.y() - pose.y, target.x() - pose.x) - pose.yaw;
    in_view += std::abs(std::remainder(bearing, 2 * M_PI)) < config.half_field_of_view_rad;
  }
  EXPECT_GT(in_view, 40);
}

TEST(RobotPath, LooksPastAWallAtHalfOfItsTarget) {
  // A screen of 1.2 m beside the lower half of somebody who lies along y.
  ColumnGrid grid({8, 6});
  TriangleMesh screen = MakeBox({0.05, 1.2, 1.5});
  screen.Transform(Eigen::Affine3f(Eigen::Translation3f(-1, -1, 0.75f)));
  grid.Add(screen);
  const Eigen::Vector2d target(0.2, 0);
  PathConfig config;
  config.half_hidden = Eigen::Vector2d(0, 0.6);
  Random random(5);
  int seen_half = 0;
  for (const RobotPose& pose : DrawPath(config, grid, {8, 6}, target, random)) {
    const auto hidden = [&](double y) {
      // Where the line of sight passes the screen.
      if (pose.x > -1) return false;
      const double share = (-1 - pose.x) / (target.x() - pose.x);
      const double at = pose.y + share * (y - pose.y);
      return at > -1.6 && at < -0.4;
    };
    seen_half += hidden(-0.6) && !hidden(0.6);
  }
  EXPECT_GT(seen_half, 20);
}

TEST(RobotPath, StandsStillWhereThereIsNoRoom) {
  ColumnGrid grid({1, 1});
  TriangleMesh block = MakeBox({1, 1, 2});
  grid.Add(block);
  Random random(1);
  EXPECT_EQ(DrawPath({}, grid, {1, 1}, std::nullopt, random).size(), 60u);
}

}  // namespace
}  // namespace fallen::sim
