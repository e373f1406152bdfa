// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/furnisher.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTries = 60;

}  // namespace

Furnisher::Furnisher(Random& random, FurniturePool pool, const FurnitureCatalogue& catalogue,
                     FurnishedRoom& room)
    : random_(random), pool_(pool), catalogue_(catalogue), room_(room) {
  const FreeFloor& free = room.free_floor;
  taken_.push_back({free.center, free.size, free.yaw});
}

const FurnitureModel* Furnisher::Draw(FurnitureRole role) {
  const auto models = catalogue_.Select(role, pool_);
  if (models.empty()) return nullptr;
  return random_.Pick(models);
}

std::optional<Footprint> Furnisher::AgainstWall(const FurnitureModel* model) {
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

std::optional<Footprint> Furnisher::Anywhere(const FurnitureModel* model, double margin_m) {
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

std::optional<Footprint> Furnisher::Facing(const FurnitureModel* model, const Footprint& other,
                                           double distance_m) {
  if (model == nullptr) return std::nullopt;
  const Eigen::Vector2d front = Eigen::Rotation2Dd(other.yaw) * Eigen::Vector2d(0, -1);
  const double reach = (other.size.y() + model->size.y()) / 2 + distance_m;
  return TryAt(*model, other.center + front * reach, other.yaw + kPi + random_.Normal(0, 0.1),
               0.02);
}

void Furnisher::ChairsAround(const Footprint& table, int count) {
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

std::optional<Footprint> Furnisher::TryAt(const FurnitureModel& model,
                                          const Eigen::Vector2d& center, double yaw,
                                          double margin_m, const Footprint* table) {
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
void Furnisher::Paint(TriangleMesh& mesh) {
  const bool black = random_.Chance(0.1);
  const double factor = black ? random_.Uniform(0.05, 0.2) : random_.Uniform(0.4, 1.3);
  for (std::uint8_t& albedo : mesh.albedo)
    albedo = static_cast<std::uint8_t>(std::clamp(factor * albedo, 5.0, 240.0));
}

bool Furnisher::InRoom(const Footprint& footprint) const {
  const Eigen::Vector2d half = room_.scene.room_size / 2;
  const double c = std::abs(std::cos(footprint.yaw)), s = std::abs(std::sin(footprint.yaw));
  const double reach_x = (footprint.size.x() * c + footprint.size.y() * s) / 2;
  const double reach_y = (footprint.size.x() * s + footprint.size.y() * c) / 2;
  return std::abs(footprint.center.x()) + reach_x <= half.x() &&
         std::abs(footprint.center.y()) + reach_y <= half.y();
}

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

}  // namespace fallen::sim
