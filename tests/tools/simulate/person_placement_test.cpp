// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/person_placement.hpp"

#include <gtest/gtest.h>

namespace fallen::sim {
namespace {

// A table of 1.4 x 0.8 m on four legs, in a room of 5 x 4 m.
Scene TableRoom() {
  TriangleMesh table = MakeBox({1.4, 0.8, 0.04});
  table.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.72f)));
  for (const float x : {-0.67f, 0.67f})
    for (const float y : {-0.37f, 0.37f}) {
      TriangleMesh leg = MakeBox({0.05, 0.05, 0.7});
      leg.Transform(Eigen::Affine3f(Eigen::Translation3f(x, y, 0.35f)));
      table.Append(leg);
    }
  Scene scene;
  scene.room_size = {5, 4};
  scene.objects.push_back(PlaceObject(kFurniture, "table", table, {0.5, 0, 0}, 0.3));
  return scene;
}

// Somebody like a log of 1.7 m, with enough points to collide with.
TriangleMesh Log() {
  TriangleMesh mesh;
  for (int i = 0; i < 20; ++i) {
    TriangleMesh slice = MakeSuperellipsoid({0.12, 0.4, 0.22}, 0.5, 0.5);
    slice.Transform(
        Eigen::Affine3f(Eigen::Translation3f(-0.8f + 0.084f * static_cast<float>(i), 0, 0.12f)));
    mesh.Append(slice);
  }
  return mesh;
}

class PlacementTest : public testing::Test {
 protected:
  PlacementTest() : grid_(scene_.room_size) { grid_.Add(scene_.objects[0].mesh); }

  // Gap between the placed log and the table's legs or top, negative inside; brute force on points.
  int PointsInside(const FloorPose& pose) const {
    const SceneObject placed =
        PlaceObject("p", "p", Log(), {pose.position.x(), pose.position.y(), 0}, pose.yaw);
    int inside = 0;
    for (const Eigen::Vector3f& vertex : placed.mesh.vertices)
      inside += grid_.Taken(vertex.cast<double>());
    return inside;
  }

  Scene scene_ = TableRoom();
  ColumnGrid grid_;
};

TEST_F(PlacementTest, FreeIsAwayFromEverything) {
  for (int seed = 0; seed < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto pose = PlaceOnFloor(Log(), Placement::kFree, std::nullopt, grid_, scene_, random);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->reached, Placement::kFree);
    EXPECT_EQ(PointsInside(*pose), 0);
  }
}

TEST_F(PlacementTest, TouchingIsOneStepFromCollision) {
  for (int seed = 0; seed < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto pose =
        PlaceOnFloor(Log(), Placement::kTouching, std::nullopt, grid_, scene_, random);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->reached, Placement::kTouching);
    int touching = 0;
    for (double angle = 0; angle < 6.3; angle += 0.2) {
      FloorPose moved = *pose;
      moved.position += 0.03 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      touching += PointsInside(moved) > 0;
    }
    EXPECT_GT(touching, 0) << seed;
  }
}

TEST_F(PlacementTest, UnderIsBelowTheTableTop) {
  for (int seed = 0; seed < 20; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto pose = PlaceOnFloor(Log(), Placement::kUnder, std::nullopt, grid_, scene_, random);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->reached, Placement::kUnder);
    const SceneObject placed =
        PlaceObject("p", "p", Log(), {pose->position.x(), pose->position.y(), 0}, pose->yaw);
    int covered = 0;
    for (const Eigen::Vector3f& vertex : placed.mesh.vertices)
      covered += grid_.Covered(vertex.cast<double>());
    EXPECT_GT(covered, static_cast<int>(placed.mesh.vertices.size() / 10));
  }
}

TEST_F(PlacementTest, KeepsAYawThatIsGiven) {
  Random random(1);
  const auto pose = PlaceOnFloor(Log(), Placement::kFree, 0.5, grid_, scene_, random);
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ(pose->yaw, 0.5);
}

TEST_F(PlacementTest, AFullRoomHasNoPlace) {
  ColumnGrid full({1.5, 1.5});
  Scene scene;
  scene.room_size = {1.5, 1.5};
  Random random(1);
  EXPECT_FALSE(PlaceOnFloor(Log(), Placement::kFree, 0.0, full, scene, random));
}

}  // namespace
}  // namespace fallen::sim
