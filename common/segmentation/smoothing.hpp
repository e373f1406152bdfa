// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/neighbor_grid.hpp"

namespace fallen {

/// Mean of `scores` over all points within `radius_m`, the point itself included
/// (the paper, Sec. III-D.3). Points for which `valid` is zero neither give nor get a score.
/// @param grid   Over the same `points`.
/// @param valid  One flag a point.
/// @return One score a point; 0 where `valid` is zero.
/// @throws std::invalid_argument if sizes disagree or the radius is negative or not finite.
/// Deterministic: summed in the grid's order, in double.
std::vector<float> SmoothScores(const NeighborGrid& grid, std::span<const Eigen::Vector3f> points,
                                std::span<const float> scores, std::span<const std::uint8_t> valid,
                                float radius_m);

}  // namespace fallen
