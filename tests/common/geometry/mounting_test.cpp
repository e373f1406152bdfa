// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/mounting.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fallen {
namespace {

TEST(MountingTest, PutsTheViewWhereTheAnglesSay) {
  const Eigen::Vector3d ahead(0, 0, 1);  // optical frame
  const Eigen::Vector3d right(1, 0, 0);
  const auto turn = [](double roll, double pitch, double yaw, const Eigen::Vector3d& direction) {
    return Eigen::Vector3d(
        T_robot_cameraFromMounting({0.1, 0.2, 0.9}, {roll, pitch, yaw}).linear() * direction);
  };
  const double s = std::sqrt(0.5);
  EXPECT_TRUE(turn(0, 0, 0, ahead).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(turn(0, 0, 0, right).isApprox(Eigen::Vector3d(0, -1, 0)));
  EXPECT_TRUE(turn(0, 45, 0, ahead).isApprox(Eigen::Vector3d(s, 0, -s)));   // down
  EXPECT_TRUE(turn(0, 0, 45, ahead).isApprox(Eigen::Vector3d(s, s, 0)));    // left
  EXPECT_TRUE(turn(45, 0, 0, right).isApprox(Eigen::Vector3d(0, -s, -s)));  // right side down
  EXPECT_TRUE(turn(0, 45, 90, ahead).isApprox(Eigen::Vector3d(0, s, -s)));  // yaw before pitch
  EXPECT_TRUE(T_robot_cameraFromMounting({0.1, 0.2, 0.9}, {1, 2, 3})
                  .translation()
                  .isApprox(Eigen::Vector3d(0.1, 0.2, 0.9)));
}

}  // namespace
}  // namespace fallen
