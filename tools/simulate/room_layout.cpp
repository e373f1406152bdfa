// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/room_layout.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "tools/simulate/furnisher.hpp"
#include "tools/simulate/room_shell.hpp"

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;

void FurnishLiving(Furnisher& furnisher, Random& random) {
  const auto sofa = furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kSofa));
  if (sofa && random.Chance(0.7))
    furnisher.Facing(furnisher.Draw(FurnitureRole::kCoffeeTable), *sofa, random.Uniform(0.3, 0.5));
  for (int i = random.Integer(0, 2); i > 0; --i)
    furnisher.Anywhere(furnisher.Draw(FurnitureRole::kArmchair), 0.15);
  for (int i = random.Integer(1, 3); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
}

void FurnishDining(Furnisher& furnisher, Random& random) {
  const auto table = furnisher.Anywhere(furnisher.Draw(FurnitureRole::kTable), 0.3);
  if (table) furnisher.ChairsAround(*table, random.Integer(2, 4));
  for (int i = random.Integer(2, 4); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
}

void FurnishBedroom(Furnisher& furnisher, Random& random) {
  furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kBed));
  for (int i = random.Integer(1, 3); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
  if (random.Chance(0.6)) furnisher.Anywhere(furnisher.Draw(FurnitureRole::kChair), 0.1);
}

void FurnishStudy(Furnisher& furnisher, Random& random) {
  const auto desk = furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kDesk));
  if (desk) furnisher.Facing(furnisher.Draw(FurnitureRole::kChair), *desk, random.Uniform(0, 0.3));
  for (int i = random.Integer(1, 3); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
  furnisher.Anywhere(furnisher.Draw(FurnitureRole::kArmchair), 0.15);
}

void FurnishKitchen(Furnisher& furnisher, Random& random) {
  for (int i = random.Integer(3, 6); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
  if (random.Chance(0.5)) {
    const auto table = furnisher.Anywhere(furnisher.Draw(FurnitureRole::kTable), 0.05);
    if (table) furnisher.ChairsAround(*table, random.Integer(1, 2));
  }
}

void FurnishBath(Furnisher& furnisher, Random& random) {
  for (int i = random.Integer(2, 4); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kBath));
  if (random.Chance(0.5)) furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
}

void FurnishCorridor(Furnisher& furnisher, Random& random) {
  for (int i = random.Integer(0, 2); i > 0; --i)
    furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kCabinet));
  if (random.Chance(0.4)) furnisher.AgainstWall(furnisher.Draw(FurnitureRole::kChair));
}

void FurnishEverything(Furnisher& furnisher, Random& random) {
  FurnishLiving(furnisher, random);
  FurnishDining(furnisher, random);
  if (random.Chance(0.3)) FurnishBedroom(furnisher, random);
}

struct RoomPlan {
  RoomKind kind;
  int share;                    // of all rooms
  Eigen::Vector2d least, most;  // size [m]
  Eigen::Vector2d free_floor;   // kept clear [m]
  void (*furnish)(Furnisher&, Random&);
};

// A tall person with arms half spread needs 2.2 m x 1.3 m; where there is less, one lies narrower.
const RoomPlan& DrawPlan(RoomKind wanted, Random& random) {
  static const std::vector<RoomPlan> plans = {
      {RoomKind::kLiving, 22, {3.8, 3.6}, {7.0, 6.0}, {2.2, 1.3}, FurnishLiving},
      {RoomKind::kDining, 10, {3.6, 3.4}, {6.0, 5.5}, {2.2, 1.3}, FurnishDining},
      {RoomKind::kBedroom, 20, {3.4, 3.3}, {5.5, 5.0}, {2.2, 1.3}, FurnishBedroom},
      {RoomKind::kStudy, 8, {3.4, 3.3}, {5.5, 5.0}, {2.2, 1.3}, FurnishStudy},
      {RoomKind::kLarge, 14, {5.0, 4.5}, {8.0, 6.5}, {2.2, 1.3}, FurnishEverything},
      {RoomKind::kNarrowLiving, 8, {4.5, 2.6}, {6.5, 3.2}, {2.1, 1.0}, FurnishLiving},
      {RoomKind::kKitchen, 8, {3.0, 2.7}, {4.5, 4.0}, {2.0, 0.9}, FurnishKitchen},
      {RoomKind::kBath, 4, {2.8, 2.5}, {3.6, 3.2}, {2.0, 0.9}, FurnishBath},
      {RoomKind::kCorridor, 6, {4.5, 1.8}, {7.5, 2.4}, {2.1, 1.0}, FurnishCorridor}};
  int draw = random.Index(100);
  for (const RoomPlan& plan : plans) {
    if (plan.kind == wanted || (wanted == RoomKind::kAny && draw < plan.share)) return plan;
    draw -= plan.share;
  }
  return plans.front();
}

FreeFloor DrawFreeFloor(Random& random, const Eigen::Vector2d& size,
                        const Eigen::Vector2d& room_size) {
  FreeFloor free;
  free.size = size;
  const auto reach_at = [&](double yaw) -> Eigen::Vector2d {
    const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
    return room_size / 2 -
           Eigen::Vector2d(c * size.x() + s * size.y(), s * size.x() + c * size.y()) / 2;
  };
  free.yaw = random.Uniform(-kPi, kPi);
  if (reach_at(free.yaw).minCoeff() < 0.1) free.yaw = random.Normal(0, 0.05);  // along the room
  const Eigen::Vector2d reach = reach_at(free.yaw).cwiseMax(0);
  free.center = {random.Uniform(-reach.x(), reach.x()), random.Uniform(-reach.y(), reach.y())};
  return free;
}

}  // namespace

FurnishedRoom FurnishRoom(int id, FurniturePool pool, const FurnitureCatalogue& catalogue,
                          int clutter, RoomKind kind) {
  Random random = Random::Stream(static_cast<std::uint64_t>(id), "room");
  FurnishedRoom room;
  const RoomPlan& plan = DrawPlan(kind, random);
  room.scene.room_size = {random.Uniform(plan.least.x(), plan.most.x()),
                          random.Uniform(plan.least.y(), plan.most.y())};
  room.height_m = random.Uniform(2.3, 2.9);
  Random shell_random = Random::Stream(static_cast<std::uint64_t>(id), "shell");
  room.scene.shell = MakeRoomShell(room.scene.room_size, room.height_m, shell_random);
  room.free_floor = DrawFreeFloor(random, plan.free_floor, room.scene.room_size);
  Furnisher furnisher(random, pool, catalogue, room);
  plan.furnish(furnisher, random);
  if (random.Chance(0.5)) furnisher.Anywhere(furnisher.Draw(FurnitureRole::kPlant), 0.1);
  for (int i = 0; i < clutter; ++i) furnisher.Anywhere(furnisher.Draw(FurnitureRole::kSmall), 0.05);
  return room;
}

}  // namespace fallen::sim
