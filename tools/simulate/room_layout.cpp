// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/room_layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "tools/simulate/random.hpp"
#include "tools/simulate/room_shell.hpp"

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTries = 60;

// Fills a room piece by piece; a piece that finds no place is left out.
class Furnisher {
 public:
  Furnisher(Random& random, FurniturePool pool, const FurnitureCatalogue& catalogue,
            FurnishedRoom& room)
      : random_(random), pool_(pool), catalogue_(catalogue), room_(room) {
    const FreeFloor& free = room.free_floor;
    taken_.push_back({free.center, free.size, free.yaw});
  }

  const FurnitureModel* Draw(FurnitureRole role) {
    const auto models = catalogue_.Select(role, pool_);
    if (models.empty()) return nullptr;
    return random_.Pick(models);
  }

  // With the back to a wall, anywhere along it.
  std::optional<Footprint> AgainstWall(const FurnitureModel* model) {
    if (model == nullptr) return std::nullopt;
    for (int i = 0; i < kTries; ++i) {
      const int wall = random_.Index(4);
      const double yaw = wall * kPi / 2;  // 0: the back to +y
      const bool along_x = wall % 2 == 0;
      const Eigen::Vector2d half = room_.scene.room_size / 2;
      const double gap = random_.Uniform(0.01, 0.06);
      const double reach = (along_x ? half.x() : half.y()) - model->size.x() / 2 - 0.02;
      if (reach <= 0) continue;
      const double along = random_.Uniform(-reach, reach);
      const double across = (along_x ? half.y() : half.x()) - model->size.y() / 2 - gap;
      const Eigen::Vector2d center =
          Eigen::Rotation2Dd(yaw) * Eigen::Vector2d(along_x ? along : along, across);
      if (const auto placed = TryAt(*model, center, yaw, 0.04)) return placed;
    }
    return std::nullopt;
  }

  // Somewhere in the room, at any angle.
  std::optional<Footprint> Anywhere(const FurnitureModel* model, double margin_m) {
    if (model == nullptr) return std::nullopt;
    const Eigen::Vector2d half = room_.scene.room_size / 2;
    for (int i = 0; i < kTries; ++i) {
      const Eigen::Vector2d center(random_.Uniform(-half.x(), half.x()),
                                   random_.Uniform(-half.y(), half.y()));
      if (const auto placed = TryAt(*model, center, random_.Uniform(-kPi, kPi), margin_m))
        return placed;
    }
    return std::nullopt;
  }

  // In front of a piece, facing it, at a distance.
  std::optional<Footprint> Facing(const FurnitureModel* model, const Footprint& other,
                                  double distance_m) {
    if (model == nullptr) return std::nullopt;
    const Eigen::Vector2d front = Eigen::Rotation2Dd(other.yaw) * Eigen::Vector2d(0, -1);
    const double reach = (other.size.y() + model->size.y()) / 2 + distance_m;
    return TryAt(*model, other.center + front * reach, other.yaw + kPi + random_.Normal(0, 0.1),
                 0.02);
  }

  // Chairs around a table, pushed in a little or left standing about.
  void ChairsAround(const Footprint& table, int count) {
    const FurnitureModel* chair = Draw(FurnitureRole::kChair);
    if (chair == nullptr) return;
    for (int i = 0; i < count; ++i) {
      const double side = table.yaw + i * kPi / 2;
      const double half = (i % 2 == 0 ? table.size.y() : table.size.x()) / 2;
      const double away = half + chair->size.y() / 2 + random_.Uniform(-0.15, 0.25);
      const Eigen::Vector2d direction = Eigen::Rotation2Dd(side) * Eigen::Vector2d(0, 1);
      TryAt(*chair, table.center + direction * away, side + random_.Normal(0, 0.25), 0.02, &table);
    }
  }

 private:
  // `table`, if given, may be entered by kTuckUnder, as chairs do.
  std::optional<Footprint> TryAt(const FurnitureModel& model, const Eigen::Vector2d& center,
                                 double yaw, double margin_m, const Footprint* table = nullptr) {
    constexpr double kTuckUnder = 0.3;
    const Footprint footprint{center, model.size.head<2>(), yaw};
    if (!InRoom(footprint)) return std::nullopt;
    for (const Footprint& other : taken_) {
      const bool is_table = table != nullptr && other.center == table->center;
      if (Overlap(footprint, other, is_table ? -kTuckUnder : margin_m)) return std::nullopt;
    }
    auto mesh = meshes_.find(model.name);
    if (mesh == meshes_.end()) mesh = meshes_.emplace(model.name, LoadFurnitureMesh(model)).first;
    TriangleMesh painted = mesh->second;
    Paint(painted);
    room_.scene.objects.push_back(
        PlaceObject(kFurniture, model.name, std::move(painted), {center.x(), center.y(), 0}, yaw));
    taken_.push_back(footprint);
    return footprint;
  }

  // Cloth and lacquer reflect as they like; black leather next to nothing.
  void Paint(TriangleMesh& mesh) {
    const bool black = random_.Chance(0.1);
    const double factor = black ? random_.Uniform(0.05, 0.2) : random_.Uniform(0.4, 1.3);
    for (std::uint8_t& albedo : mesh.albedo)
      albedo = static_cast<std::uint8_t>(std::clamp(factor * albedo, 5.0, 240.0));
  }

  bool InRoom(const Footprint& footprint) const {
    const Eigen::Vector2d half = room_.scene.room_size / 2;
    const double c = std::abs(std::cos(footprint.yaw)), s = std::abs(std::sin(footprint.yaw));
    const double reach_x = (footprint.size.x() * c + footprint.size.y() * s) / 2;
    const double reach_y = (footprint.size.x() * s + footprint.size.y() * c) / 2;
    return std::abs(footprint.center.x()) + reach_x <= half.x() &&
           std::abs(footprint.center.y()) + reach_y <= half.y();
  }

  Random& random_;
  FurniturePool pool_;
  const FurnitureCatalogue& catalogue_;
  FurnishedRoom& room_;
  std::vector<Footprint> taken_;
  std::map<std::string, TriangleMesh> meshes_;
};

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

bool Overlap(const Footprint& a, const Footprint& b, double margin_m) {
  for (const Footprint* reference : {&a, &b}) {
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d direction =
          Eigen::Rotation2Dd(reference->yaw) * Eigen::Vector2d(Eigen::Vector2d::Unit(axis));
      double reach = margin_m;
      for (const Footprint* footprint : {&a, &b}) {
        const Eigen::Vector2d local = Eigen::Rotation2Dd(-footprint->yaw) * direction;
        reach += local.cwiseAbs().dot(footprint->size) / 2;
      }
      if (std::abs(direction.dot(a.center - b.center)) >= reach) return false;
    }
  }
  return true;
}

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
