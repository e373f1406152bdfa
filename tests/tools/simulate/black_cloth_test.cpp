// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/black_cloth.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tools/simulate/depth_sensor.hpp"

namespace fallen::sim {
namespace {

TEST(WearBlack, TurnsAsManyClothesBlackAsItsChanceSays) {
  int black = 0;
  for (int id = 0; id < 300; ++id) {
    const BodyShape before = DrawBodyShape(id);
    BodyShape after = before;
    WearBlack(0.25, Random(static_cast<std::uint64_t>(id)), after);
    EXPECT_EQ(after.height_m, before.height_m);
    for (const auto albedo :
         {&BodyShape::top_albedo, &BodyShape::legs_albedo, &BodyShape::hair_albedo}) {
      if (after.*albedo == before.*albedo) continue;
      EXPECT_LE(after.*albedo, 0.04);
      ++black;
    }
  }
  EXPECT_NEAR(black / 900.0, 0.25, 0.05);  // three standard deviations are 0.043
}

TEST(WearBlack, LeavesEverythingWithoutAChance) {
  BodyShape shape = DrawBodyShape(3);
  const double top = shape.top_albedo;
  WearBlack(0, Random(1), shape);
  EXPECT_EQ(shape.top_albedo, top);
}

TEST(CoverInBlack, SwallowsTheSensorsLight) {
  Scene scene;
  scene.shell = MakeBox({20, 20, 0.1}, 0.8);
  scene.shell.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 4.05f)));
  const auto lost = [&] {
    const SensorImage image =
        TakePicture(RayCaster(scene), SensorIntrinsics(320), Eigen::Isometry3d::Identity(), {}, 5);
    return static_cast<double>(std::ranges::count(image.depth.depth, 0)) / (320 * 240);
  };
  EXPECT_LT(lost(), 0.02);
  CoverInBlack(0, Random(1), scene.shell);
  EXPECT_LT(lost(), 0.02);
  CoverInBlack(1, Random(1), scene.shell);
  EXPECT_GT(lost(), 0.4);
}

}  // namespace
}  // namespace fallen::sim
