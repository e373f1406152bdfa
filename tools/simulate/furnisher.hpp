// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/random.hpp"
#include "tools/simulate/room_layout.hpp"

namespace fallen::sim {

/// Fills a room piece by piece; a piece that finds no place is left out. Keeps references.
class Furnisher {
 public:
  Furnisher(Random& random, FurniturePool pool, const FurnitureCatalogue& catalogue,
            FurnishedRoom& room);

  /// A model of the role, or null where the pool has none. Null is left out below.
  const FurnitureModel* Draw(FurnitureRole role);

  /// With the back to a wall, anywhere along it.
  std::optional<Footprint> AgainstWall(const FurnitureModel* model);
  /// Somewhere in the room, at any angle.
  std::optional<Footprint> Anywhere(const FurnitureModel* model, double margin_m);
  /// In front of a piece, facing it, at a distance.
  std::optional<Footprint> Facing(const FurnitureModel* model, const Footprint& other,
                                  double distance_m);
  /// Chairs around a table, pushed in a little or left standing about.
  void ChairsAround(const Footprint& table, int count);

 private:
  /// `table`, if given, may be entered by as much as chairs are pushed in.
  std::optional<Footprint> TryAt(const FurnitureModel& model, const Eigen::Vector2d& center,
                                 double yaw, double margin_m, const Footprint* table = nullptr);
  void Paint(TriangleMesh& mesh);
  bool InRoom(const Footprint& footprint) const;

  Random& random_;
  FurniturePool pool_;
  const FurnitureCatalogue& catalogue_;
  FurnishedRoom& room_;
  std::vector<Footprint> taken_;
  std::map<std::string, TriangleMesh> meshes_;
};

}  // namespace fallen::sim
