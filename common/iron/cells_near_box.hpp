// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/iron/neighbor_grid.hpp"

namespace fallen {

/// Coordinates of points one after the other, readable for kMostLanes beyond the last.
struct PointColumns {
  const float *x, *y, *z;
};

/// The box around some points, and how far from it others are looked for.
struct BoxSurroundings {
  std::array<float, 3> low, high;
  float sq_radius;  ///< [m^2]
};

/// Writes the positions of the points of `runs` that may lie within the radius of a point in the
/// box, in their order, and returns how many there are.
///
/// Left out are those that lie farther from the box itself. That is safe to the last bit for all
/// who compare dx dx + dy dy + dz dz in float: rounding keeps the order of differences, squares and
/// sums, so that no point in the box is nearer than its nearest side.
/// @param positions  Room for all of `runs` and kMostLanes more.
/// The same positions at every SimdLevel.
int FindNearBox(const PointColumns& points, const CellRun* runs, int run_count,
                const BoxSurroundings& box, std::int32_t* positions);

}  // namespace fallen
