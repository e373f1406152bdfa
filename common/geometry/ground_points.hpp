// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fallen/geometry/depth_image.hpp"

namespace fallen {

/// A pixel of the thinned image, as the ground estimators see it.
///
/// A plane is linear in inverse depth: with the ray (x, y, 1) and 1/z = a x + b y + c it holds the
/// points p with (a, b, c) . p = 1. So a local plane is a gradient, and, as PrimeSense sensors
/// measure disparity, inverse depth has the same noise at every range.
struct GroundPoint {
  Eigen::Vector3f position;  ///< camera frame [m]
  Eigen::Vector3f ray;       ///< position / z: (x, y, 1)
  float inverse_depth = 0;   ///< [1/m]
  Eigen::Vector3f normal;    ///< of the local surface, towards the camera; 0 if unknown
};

/// Thins `image` on a regular grid to about `sample_points` pixels, and gives the measured ones.
///
/// O(sample_points). Deterministic; row by row.
std::vector<GroundPoint> SampleGroundPoints(const DepthImage& image, int sample_points);

}  // namespace fallen
