// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/cell_tiles.hpp"
#include "fallen/segmentation/score_sums.hpp"

namespace fallen {

/// Averages scores over neighbours, frame after frame in the same memory.
class ScoreSmoother {
 public:
  /// Mean of `scores` over all points within `radius_m`, the point itself included
  /// (the paper, Sec. III-D.3). Points for which `valid` is zero neither give nor get a score.
  /// @param tiles  Over the points; only its bases get a score.
  /// @param valid  One flag a point.
  /// @return One score a point; 0 where `valid` is zero and where the point is no base. Holds until
  /// the next call.
  /// @throws std::invalid_argument if sizes disagree or the radius is negative or not finite.
  /// Deterministic: summed in the grid's order, in float, the same bits at every SimdLevel.
  const std::vector<float>& Smooth(CellTiles& tiles, std::span<const float> scores,
                                   std::span<const std::uint8_t> valid, float radius_m);

 private:
  std::vector<float> smoothed_;
  std::vector<ScoredPoint> points_;  // in grid order
};

}  // namespace fallen
