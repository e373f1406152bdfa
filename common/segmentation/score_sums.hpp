// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/simd/lanes.hpp"

namespace fallen {

/// A point with its part in the means of its neighbours.
struct ScoredPoint {
  float x, y, z;
  float score;         ///< 0 if it has none
  std::int32_t count;  ///< 1, or 0 if it has no score
};

/// Points side by side, one a lane, and what lies near them.
struct alignas(64) ScoreSums {
  std::array<float, kMostLanes> x, y, z;
  std::array<float, kMostLanes> sum;           ///< of the scores within the radius
  std::array<std::int32_t, kMostLanes> count;  ///< of the points that have one
};

/// Sums the scores of the points at `near` within the radius of each lane's point, in their order.
/// The same bits at every SimdLevel.
void SumScores(const ScoredPoint* points, const std::int32_t* near, int near_count, float sq_radius,
               ScoreSums& sums);

}  // namespace fallen
