// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fallen {

/// Points of surfaces in the frame `level` of LevelFrameFromGround: below the camera, z up from the
/// floor [m].
struct SurfaceCloud {
  std::vector<Eigen::Vector3f> points;
  /// One a point: unit vector towards the camera, or zero where too few neighbours are known.
  std::vector<Eigen::Vector3f> normals;
};

}  // namespace fallen
