// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/resting_person.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"

namespace fallen::sim {
namespace {

using RestingPersonTest = WithAssets;

// A sofa of two boxes: seat 0.4 m high, back 0.8 m high, under the name of one that is known.
Scene SofaRoom(double yaw) {
  TriangleMesh sofa = MakeBox({2.0, 0.9, 0.4});
  sofa.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.2f)));
  TriangleMesh back = MakeBox({2.0, 0.15, 0.8});
  back.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0.375f, 0.4f)));
  sofa.Append(back);
  // Corners only would leave the middle of the seat without a vertex.
  for (float x = -0.6f; x <= 0.6f; x += 0.1f) sofa.vertices.push_back({x, -0.1f, 0.4f});
  Scene scene;
  scene.room_size = {5, 5};
  scene.objects.push_back(
      PlaceObject(kFurniture, "KatorLegaz/futon-couch", sofa, {1, 0.5, 0}, yaw));
  return scene;
}

TEST_F(RestingPersonTest, LiesOnTheSeatAlongTheSofa) {
  for (const double yaw : {0.0, 1.2}) {
    const Scene scene = SofaRoom(yaw);
    Random random(3);
    const auto sleeper = MakeRestingPerson(assets().humans, scene, random);
    ASSERT_TRUE(sleeper);
    EXPECT_NE(sleeper->category, kFallenPerson);
    EXPECT_NEAR(sleeper->mesh.Bounds().min().z(), 0.4, 0.02);
    EXPECT_NEAR((sleeper->box.center - scene.objects[0].box.center).head<2>().norm(), 0, 0.25);
    // Along the sofa, give or take spread arms.
    EXPECT_NEAR(std::remainder(sleeper->box.yaw - yaw, M_PI), 0, 0.5);
  }
}

TEST_F(RestingPersonTest, SitsOnTheSeatFacingAwayFromItsBack) {
  for (const double yaw : {0.0, 1.2}) {
    const Scene scene = SofaRoom(yaw);
    Random random(4);
    const auto seated = MakeSeatedPerson(assets().humans, scene, random);
    ASSERT_TRUE(seated);
    EXPECT_EQ(seated->category, kSeated);
    EXPECT_GT(seated->mesh.Bounds().max().z(), 0.4 + 0.5);
    // Legs are before the front edge, nothing is behind the back.
    const Eigen::Rotation2Df to_sofa(static_cast<float>(-yaw));
    float front = 0, rear = 0;
    for (const Eigen::Vector3f& vertex : seated->mesh.vertices) {
      const Eigen::Vector2f p =
          to_sofa * (vertex.head<2>() - scene.objects[0].box.center.head<2>().cast<float>());
      front = std::min(front, p.y());
      rear = std::max(rear, p.y());
    }
    EXPECT_LT(front, -0.45f);
    EXPECT_LT(rear, 0.45f);
  }
}

TEST_F(RestingPersonTest, NeedsSomethingToLieOn) {
  Scene scene = SofaRoom(0);
  scene.objects[0].name = "KatorLegaz/fridge";
  Random random(3);
  EXPECT_FALSE(MakeRestingPerson(assets().humans, scene, random));
  EXPECT_FALSE(MakeSeatedPerson(assets().humans, scene, random));
}

}  // namespace
}  // namespace fallen::sim
