// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fallen/geometry/enum_names.hpp"

namespace fallen {

enum class ZoneKind {
  kNever,  ///< nobody lies here: a dog's basket, a mirror, an area outside the flat
  kBed,    ///< lying here is no fall, unless it is on the floor
};
constexpr auto EnumNames(ZoneKind) {
  return EnumTable<ZoneKind, 2>{{{ZoneKind::kNever, "never"}, {ZoneKind::kBed, "bed"}}};
}

/// A part of the floor where the alarm has other rules: a polygon in the world.
struct Zone {
  std::string name;
  ZoneKind kind = ZoneKind::kNever;
  std::vector<Eigen::Vector2d> corners;  ///< world x, y [m], in order, either way round
  /// kBed: who lies lower than this has fallen out of it [m].
  double bed_height_m = 0.35;

  /// @throws std::invalid_argument for fewer than three corners, an edge that crosses or touches
  /// another, or a value that is not finite.
  void Validate() const;

  /// True if a person with this centroid (world, floor at z = 0) is none of the alarm's business.
  bool Excludes(const Eigen::Vector3d& centroid) const;
};

}  // namespace fallen
