// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/body_shape.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"

namespace fallen::sim {
namespace {

using BodyShapeTest = WithAssets;

TEST_F(BodyShapeTest, BodiesReachTheHeightTheyShould) {
  for (int id = 1; id <= 10; ++id) {
    const BodyShape shape = DrawBodyShape(id);
    EXPECT_GE(shape.height_m, 1.45);
    EXPECT_LE(shape.height_m, 1.95);
    EXPECT_NEAR(MakeRestBody(assets().humans, shape).height_m, shape.height_m, 0.005) << id;
  }
}

TEST_F(BodyShapeTest, WeightMakesBellies) {
  BodyShape shape = DrawBodyShape(1);
  const auto depth_of_trunk = [&](double weight) {
    shape.weight = weight;
    const RestBody body = MakeRestBody(assets().humans, shape);
    const double height =
        body.bone_heads[static_cast<std::size_t>(assets().humans.bone("spine04"))].y();
    double front = -1, back = 1;
    for (const int v : body.body_vertices) {
      if (std::abs(body.skin(1, v) - height) > 0.03 || std::abs(body.skin(0, v)) > 0.05) continue;
      front = std::max<double>(front, body.skin(2, v));
      back = std::min<double>(back, body.skin(2, v));
    }
    return front - back;
  };
  EXPECT_GT(depth_of_trunk(1), depth_of_trunk(-1) + 0.05);  // [m]
}

TEST_F(BodyShapeTest, ClothesLieOutsideTheSkin) {
  const RestBody body = MakeRestBody(assets().humans, DrawBodyShape(3));
  double most = 0;
  for (const int v : body.body_vertices)
    most = std::max<double>(most, (body.dressed.col(v) - body.skin.col(v)).norm());
  EXPECT_GT(most, 0.003);
  EXPECT_LT(most, 2 * std::max(body.shape.top_thickness_m, body.shape.legs_thickness_m) + 0.01);
}

TEST_F(BodyShapeTest, AnUnknownTargetIsNamed) {
  BodyShape shape = DrawBodyShape(3);
  shape.details["wings/wings-large"] = 1;
  EXPECT_THROW(MakeRestBody(assets().humans, shape), std::runtime_error);
}

TEST(DrawBodyShape, IsTheSameForTheSameNumber) {
  EXPECT_EQ(DrawBodyShape(4).height_m, DrawBodyShape(4).height_m);
  EXPECT_NE(DrawBodyShape(4).height_m, DrawBodyShape(5).height_m);
}

}  // namespace
}  // namespace fallen::sim
