// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace fallen {

inline constexpr double kBodyRadiusM = 0.15;
inline constexpr double kBodyLengthM = 1.6;

/// Upper half of a cylinder on the floor 3 m ahead of the origin and 1 m below it, across the view;
/// optical frame, points about 17 mm apart.
inline std::vector<Eigen::Vector3d> HalfCylinder() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 94; ++i)
    for (int j = 0; j <= 27; ++j) {
      const double angle = std::numbers::pi * j / 27;
      points.emplace_back(kBodyLengthM * (i / 94.0 - 0.5), 1 - kBodyRadiusM * std::sin(angle),
                          3 + kBodyRadiusM * std::cos(angle));
    }
  return points;
}

}  // namespace fallen
