// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/smoothing.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {

std::vector<float> SmoothScores(const NeighborGrid& grid, std::span<const Eigen::Vector3f> points,
                                std::span<const float> scores, std::span<const std::uint8_t> valid,
                                float radius_m) {
  if (grid.size() != points.size() || scores.size() != points.size() ||
      valid.size() != points.size())
    throw std::invalid_argument("smoothing: got " + std::to_string(points.size()) + " points, " +
                                std::to_string(scores.size()) + " scores, " +
                                std::to_string(valid.size()) + " flags and a grid of " +
                                std::to_string(grid.size()) + ", must be equally many");
  if (!(radius_m >= 0) || !std::isfinite(radius_m))
    throw std::invalid_argument("smoothing: radius_m is " + std::to_string(radius_m) +
                                ", must be >= 0 and finite");

  std::vector<float> smoothed(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!valid[i]) continue;
    double sum = 0;
    int count = 0;
    grid.ForEachWithin(points[i], radius_m, [&](std::int32_t neighbor, float) {
      if (!valid[neighbor]) return;
      sum += scores[neighbor];
      ++count;
    });
    smoothed[i] = static_cast<float>(sum / count);
  }
  return smoothed;
}

}  // namespace fallen
