// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {

const std::vector<float>& ScoreSmoother::Smooth(CellTiles& tiles, std::span<const float> scores,
                                                std::span<const std::uint8_t> valid,
                                                float radius_m) {
  const NeighborGrid& grid = tiles.grid();
  if (scores.size() != grid.size() || valid.size() != grid.size())
    throw std::invalid_argument("smoothing: got " + std::to_string(scores.size()) + " scores, " +
                                std::to_string(valid.size()) + " flags and tiles over " +
                                std::to_string(grid.size()) + " points, must be equally many");
  if (!(radius_m >= 0) || !std::isfinite(radius_m))
    throw std::invalid_argument("smoothing: radius_m is " + std::to_string(radius_m) +
                                ", must be >= 0 and finite");

  points_.resize(grid.size());
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const Eigen::Vector3f& point = grid.sorted_points()[k];
    const std::int32_t i = grid.sorted_index()[k];
    points_[k] = {point.x(), point.y(), point.z(), valid[i] ? scores[i] : 0.0F, valid[i] ? 1 : 0};
  }
  smoothed_.assign(grid.size(), 0.0F);
  for (const CellTile& tile : tiles.tiles()) {
    const std::span<const std::int32_t> near = tiles.FindNear(tile, radius_m);
    const std::span<const std::int32_t> bases = tiles.bases_of(tile);
    ScoreSums sums;
    for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
      const ScoredPoint& point = points_[bases[std::min(lane, bases.size() - 1)]];
      sums.x[lane] = point.x;
      sums.y[lane] = point.y;
      sums.z[lane] = point.z;
    }
    SumScores(points_.data(), near.data(), static_cast<int>(near.size()), radius_m * radius_m,
              sums);
    for (std::size_t lane = 0; lane < bases.size(); ++lane)
      if (points_[bases[lane]].count > 0)
        smoothed_[grid.sorted_index()[bases[lane]]] =
            sums.sum[lane] / static_cast<float>(sums.count[lane]);
  }
  return smoothed_;
}

}  // namespace fallen
