// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/room_layout.hpp"

#include <set>

#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/room_shell.hpp"

namespace fallen::sim {
namespace {

// Whether any of a fine grid of points is in both.
bool OverlapByPoints(const Footprint& a, const Footprint& b) {
  const auto inside = [](const Footprint& f, const Eigen::Vector2d& p) {
    const Eigen::Vector2d local = Eigen::Rotation2Dd(-f.yaw) * (p - f.center);
    return (local.cwiseAbs().array() <= f.size.array() / 2).all();
  };
  for (double s = -0.5; s <= 0.5; s += 0.02)
    for (double t = -0.5; t <= 0.5; t += 0.02)
      if (inside(b, a.center + Eigen::Rotation2Dd(a.yaw) *
                                   Eigen::Vector2d(s * a.size.x(), t * a.size.y())))
        return true;
  return false;
}

TEST(Overlap, AgreesWithPoints) {
  Random random(2);
  int overlapping = 0;
  for (int i = 0; i < 500; ++i) {
    const auto draw = [&] {
      return Footprint{{random.Uniform(-1, 1), random.Uniform(-1, 1)},
                       {random.Uniform(0.2, 1.5), random.Uniform(0.2, 1.5)},
                       random.Uniform(-3, 3)};
    };
    const Footprint a = draw(), b = draw();
    // Points are 3 cm apart at most: contact thinner than that is anybody's guess.
    if (Overlap(a, b, 0.03) != Overlap(a, b, -0.03)) continue;
    EXPECT_EQ(Overlap(a, b, 0), OverlapByPoints(a, b)) << i;
    overlapping += Overlap(a, b, 0);
  }
  EXPECT_GT(overlapping, 50);
}

using FurnishRoomTest = WithAssets;

TEST_F(FurnishRoomTest, TheSameNumberIsTheSameRoom) {
  const FurnishedRoom a = FurnishRoom(12, FurniturePool::kTrain, assets().furniture, 3);
  const FurnishedRoom b = FurnishRoom(12, FurniturePool::kTrain, assets().furniture, 3);
  ASSERT_EQ(a.scene.objects.size(), b.scene.objects.size());
  for (std::size_t i = 0; i < a.scene.objects.size(); ++i) {
    EXPECT_EQ(a.scene.objects[i].name, b.scene.objects[i].name);
    EXPECT_EQ(a.scene.objects[i].box, b.scene.objects[i].box);
  }
}

TEST_F(FurnishRoomTest, NothingOverlapsAndFreeFloorStaysFree) {
  int objects = 0;
  for (int id = 1; id <= 12; ++id) {
    const FurnishedRoom room = FurnishRoom(id, FurniturePool::kTrain, assets().furniture, 2);
    std::vector<Footprint> footprints = {
        {room.free_floor.center, room.free_floor.size, room.free_floor.yaw}};
    for (const SceneObject& object : room.scene.objects) {
      footprints.push_back(
          {object.box.center.head<2>(), object.box.size.head<2>(), object.box.yaw});
      EXPECT_LT(std::abs(object.box.center.x()), room.scene.room_size.x() / 2) << object.name;
      EXPECT_NEAR(object.box.center.z(), object.box.size.z() / 2, 0.16)
          << object.name;  // on the floor
    }
    objects += static_cast<int>(room.scene.objects.size());
    for (std::size_t i = 0; i < footprints.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        // Chairs may stand under tables by up to 30 cm.
        EXPECT_FALSE(Overlap(footprints[i], footprints[j], -0.32)) << id << ": " << i << " " << j;
    for (std::size_t i = 1; i < footprints.size(); ++i)
      EXPECT_FALSE(Overlap(footprints[0], footprints[i], -1e-3));
  }
  EXPECT_GT(objects, 12 * 3);
}

TEST_F(FurnishRoomTest, EveryKindHasFloorForAPersonAndItsFurniture) {
  for (const auto& [kind, name] : EnumNames(RoomKind{})) {
    std::size_t pieces = 0;
    for (int id = 1; id <= 3; ++id) {
      const FurnishedRoom room = FurnishRoom(id, FurniturePool::kTest, assets().furniture, 0, kind);
      pieces += room.scene.objects.size();
      EXPECT_GE(room.free_floor.size.x(), 1.9) << name;
      EXPECT_GE(room.free_floor.size.y(), 0.85) << name;
      const Eigen::Vector2d half = room.scene.room_size / 2;
      for (const double s : {-0.5, 0.5}) {
        const Eigen::Vector2d end =
            room.free_floor.center + Eigen::Rotation2Dd(room.free_floor.yaw) *
                                         Eigen::Vector2d(s * room.free_floor.size.x(), 0);
        EXPECT_LT(std::abs(end.x()), half.x() + 0.05) << name;
        EXPECT_LT(std::abs(end.y()), half.y() + 0.05) << name;
      }
    }
    EXPECT_GE(pieces, 2u) << name;
  }
}

TEST_F(FurnishRoomTest, BedroomsOfEveryPoolHaveBeds) {
  for (const FurniturePool pool :
       {FurniturePool::kTrain, FurniturePool::kValidation, FurniturePool::kTest}) {
    int beds = 0;
    for (int id = 1; id <= 5; ++id) {
      const FurnishedRoom room = FurnishRoom(id, pool, assets().furniture, 0, RoomKind::kBedroom);
      for (const SceneObject& object : room.scene.objects)
        beds += RoleOf(object.name) == FurnitureRole::kBed;
    }
    EXPECT_GE(beds, 2);
  }
}

TEST(RoomShell, ReachesTheCeilingAndKeepsTheFloorLevel) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    const TriangleMesh shell = MakeRoomShell({4, 3}, 2.5, random);
    EXPECT_EQ(shell.albedo.size(), shell.triangles.size());
    double highest_inside = 0;
    for (const Eigen::Vector3f& vertex : shell.vertices)
      if (std::abs(vertex.x()) < 1.98f && std::abs(vertex.y()) < 1.48f && vertex.z() < 2.4f)
        highest_inside = std::max<double>(highest_inside, vertex.z());
    EXPECT_LE(highest_inside, 0.011);  // rugs, and nothing else away from the walls
    EXPECT_NEAR(shell.Bounds().max().z(), 2.6, 0.01);
  }
}

}  // namespace
}  // namespace fallen::sim
