// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fallen/geometry/enum_names.hpp"
#include "tools/simulate/column_grid.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/room_layout.hpp"

namespace fallen::sim {

/// How something that lies on the floor relates to the furniture.
enum class Placement { kFree, kTouching, kUnder };
constexpr auto EnumNames(Placement) {
  return EnumTable<Placement, 3>{{{Placement::kFree, "free"},
                                  {Placement::kTouching, "touching"},
                                  {Placement::kUnder, "under"}}};
}

struct FloorPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double yaw = 0;
  Placement reached = Placement::kFree;  ///< what was possible in this room
};

/// Finds a place for a mesh that rests on the floor around its own origin.
///
/// `kFree`: a hand's breadth from everything. `kTouching`: pushed against a piece of furniture
/// until it touches. `kUnder`: partly below a piece; where no piece allows that, touching, else
/// free.
/// @param yaw  Fixed yaw, or nothing for any.
/// @return Nothing if even a free place was not found.
std::optional<FloorPose> PlaceOnFloor(const TriangleMesh& mesh, Placement placement,
                                      const std::optional<double>& yaw, const ColumnGrid& grid,
                                      const Scene& scene, Random& random);

}  // namespace fallen::sim
