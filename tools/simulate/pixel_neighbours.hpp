// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "tools/simulate/ray_caster.hpp"

namespace fallen::sim {

/// Depth of that of the four neighbours whose depth differs the most, if it differs by more than
/// 3 % of the pixel's own: there a sensor sees two depths at once. Else the pixel's own.
inline double DepthAcrossEdge(const IdealView& view, int width, int height, int u, int v) {
  constexpr float kEdgeStep = 0.03f;
  const float depth = view.depth_m[static_cast<std::size_t>(v * width + u)];
  float across = depth, largest = kEdgeStep * depth;
  const auto look = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const float other = view.depth_m[static_cast<std::size_t>(y * width + x)];
    if (std::abs(other - depth) <= largest) return;
    largest = std::abs(other - depth);
    across = other;
  };
  look(u - 1, v);
  look(u + 1, v);
  look(u, v - 1);
  look(u, v + 1);
  return across;
}

inline bool AtEdge(const IdealView& view, int width, int height, int u, int v) {
  return DepthAcrossEdge(view, width, height, u, v) !=
         view.depth_m[static_cast<std::size_t>(v * width + u)];
}

}  // namespace fallen::sim
