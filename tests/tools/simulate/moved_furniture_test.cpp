// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/moved_furniture.hpp"

#include <gtest/gtest.h>

#include "tools/simulate/room_layout.hpp"

namespace fallen::sim {
namespace {

/// A room of 6 x 6 m with six low blocks, one of them somebody's and not furniture.
Scene Blocks() {
  Scene scene;
  scene.room_size = {6, 6};
  for (int i = 0; i < 6; ++i) {
    TriangleMesh block = MakeBox({0.8, 0.4, 0.5});
    block.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.25F)));
    scene.objects.push_back(PlaceObject(i == 5 ? "dog" : kFurniture, std::to_string(i), block,
                                        {-2.5 + i, i % 2 - 0.5, 0}, 0.1));
  }
  return scene;
}

double Moved(const SceneObject& a, const SceneObject& b) {
  return (a.box.center - b.box.center).norm();
}

TEST(MovedFurniture, MovesTheShareOfThePiecesAndNothingElse) {
  const Scene before = Blocks();
  Scene after = before;
  Random random(3);
  EXPECT_EQ(MoveFurniture(after, 0.4, random), 2);  // of five
  ASSERT_EQ(after.objects.size(), before.objects.size());
  int moved = 0;
  for (std::size_t i = 0; i < after.objects.size(); ++i) {
    const SceneObject& piece = after.objects[i];
    EXPECT_EQ(piece.name, before.objects[i].name);
    const double distance = Moved(piece, before.objects[i]);
    if (distance == 0) continue;
    ++moved;
    EXPECT_GE(distance, 0.5);
    EXPECT_EQ(piece.category, kFurniture);
    EXPECT_NEAR(piece.box.size.z(), 0.5, 1e-5);
    EXPECT_NEAR(piece.mesh.Bounds().min().z(), 0, 1e-5);
    for (std::size_t k = 0; k < after.objects.size(); ++k) {
      const OrientedBox &a = piece.box, &b = after.objects[k].box;
      if (k == i) continue;
      EXPECT_FALSE(Overlap({a.center.head<2>(), a.size.head<2>(), a.yaw},
                           {b.center.head<2>(), b.size.head<2>(), b.yaw}, -0.03));
    }
  }
  EXPECT_EQ(moved, 2);
}

TEST(MovedFurniture, IsTheSameForTheSameStreamAndNoneForNoShare) {
  Scene a = Blocks(), b = Blocks(), none = Blocks();
  Random first(7), second(7), third(7);
  MoveFurniture(a, 0.6, first);
  MoveFurniture(b, 0.6, second);
  EXPECT_EQ(MoveFurniture(none, 0, third), 0);
  const Scene before = Blocks();
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].box, b.objects[i].box);
    EXPECT_EQ(none.objects[i].box, before.objects[i].box);
  }
}

TEST(MovedFurniture, StaysWhereThereIsNoOtherPlace) {
  Scene scene;
  scene.room_size = {1, 0.5};
  scene.objects.push_back(
      PlaceObject(kFurniture, "bed", MakeBox({0.95, 0.45, 0.5}), {0, 0, 0.25}, 0));
  Random random(1);
  EXPECT_EQ(MoveFurniture(scene, 1, random), 0);
  EXPECT_EQ(scene.objects[0].box.center.x(), 0);
}

}  // namespace
}  // namespace fallen::sim
