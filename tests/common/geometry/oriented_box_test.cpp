// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/oriented_box.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

namespace fallen {
namespace {

TEST(OrientedBox, SurfaceBelongsToTheBox) {
  const OrientedBox box{{1, 2, 3}, {2, 4, 6}, 0};
  EXPECT_TRUE(box.Contains({2, 4, 6}));
  EXPECT_TRUE(box.Contains({0, 0, 0}));
  EXPECT_FALSE(box.Contains({2 + 1e-9, 2, 3}));
  EXPECT_FALSE(box.Contains({1, 4 + 1e-9, 3}));
  EXPECT_FALSE(box.Contains({1, 2, -1e-9}));
}

TEST(OrientedBox, YawTurnsFromXToY) {
  const double pi = std::acos(-1.0);
  const OrientedBox box{{0, 0, 0}, {2, 0.2, 1}, pi / 2};  // long along y now
  EXPECT_TRUE(box.Contains({0, 0.9, 0}));
  EXPECT_FALSE(box.Contains({0.9, 0, 0}));
  const OrientedBox diagonal{{0, 0, 0}, {2, 0.2, 1}, pi / 4};
  EXPECT_TRUE(diagonal.Contains({0.6, 0.6, 0}));
  EXPECT_FALSE(diagonal.Contains({0.6, -0.6, 0}));
}

TEST(OrientedBox, AgreesWithBoxInItsOwnFrame) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int inside = 0;
  for (int i = 0; i < 10000; ++i) {
    const OrientedBox box{{1000 + uniform(random), uniform(random), uniform(random)},
                          {1 + uniform(random), 1 + uniform(random), 1 + uniform(random)},
                          10 * uniform(random)};
    const Eigen::Vector3d p =
        box.center + Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
    Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();
    T_world_box.translate(box.center).rotate(Eigen::AngleAxisd(box.yaw, Eigen::Vector3d::UnitZ()));
    const Eigen::AlignedBox3d own(-box.size / 2, box.size / 2);
    EXPECT_EQ(box.Contains(p), own.contains(Eigen::Vector3d(T_world_box.inverse() * p)));
    inside += box.Contains(p);
  }
  EXPECT_GT(inside, 500);
}

TEST(OrientedBox, FlatBoxContainsItsCentreAndNoNan) {
  const OrientedBox flat{{1, 1, 1}, {0, 0, 0}, 0.3};
  EXPECT_TRUE(flat.Contains({1, 1, 1}));
  EXPECT_FALSE(flat.Contains({1, 1, 1.001}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(OrientedBox({{0, 0, 0}, {1, 1, 1}, 0}).Contains({nan, 0, 0}));
  EXPECT_FALSE(OrientedBox({{0, 0, 0}, {1, 1, 1}, nan}).Contains({0, 0, 0}));
}

}  // namespace
}  // namespace fallen
