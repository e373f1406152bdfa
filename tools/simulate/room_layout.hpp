// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tools/simulate/furniture_catalogue.hpp"
#include "tools/simulate/scene.hpp"

namespace fallen::sim {

enum class RoomKind {
  kAny,  ///< drawn by the room's number
  kLiving,
  kDining,
  kBedroom,
  kStudy,
  kLarge,  ///< a room for everything
  kNarrowLiving,
  kKitchen,
  kBath,
  kCorridor,
};
constexpr auto EnumNames(RoomKind) {
  return EnumTable<RoomKind, 10>{{{RoomKind::kAny, "any"},
                                  {RoomKind::kLiving, "living"},
                                  {RoomKind::kDining, "dining"},
                                  {RoomKind::kBedroom, "bedroom"},
                                  {RoomKind::kStudy, "study"},
                                  {RoomKind::kLarge, "large"},
                                  {RoomKind::kNarrowLiving, "narrow_living"},
                                  {RoomKind::kKitchen, "kitchen"},
                                  {RoomKind::kBath, "bath"},
                                  {RoomKind::kCorridor, "corridor"}}};
}

/// An empty stretch of floor that furniture leaves free: somebody can lie there.
struct FreeFloor {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double yaw = 0;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

struct FurnishedRoom {
  Scene scene;
  FreeFloor free_floor;
  double height_m = 2.5;
};

/// Room `id` with furniture of a pool: the same room for the same arguments, whoever is in it.
///
/// Sofas, beds and cabinets stand along walls, tables have chairs, nothing overlaps. Of a hundred
/// rooms some 30 are living rooms, a fourth of them narrow, 20 bedrooms, 14 large ones for
/// everything, 10 dining rooms, 8 studies, 8 kitchens, 6 corridors and 4 bathrooms.
/// @param clutter  How many small things stand about.
FurnishedRoom FurnishRoom(int id, FurniturePool pool, const FurnitureCatalogue& catalogue,
                          int clutter, RoomKind kind = RoomKind::kAny);

/// Upright rectangle on the floor, to keep things apart.
struct Footprint {
  Eigen::Vector2d center;
  Eigen::Vector2d size;
  double yaw;
};
/// True if two rectangles come closer than `margin_m` (separating axes; corners count as closer).
bool Overlap(const Footprint& a, const Footprint& b, double margin_m);

}  // namespace fallen::sim
