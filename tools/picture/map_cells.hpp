// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "tools/picture/colors.hpp"

namespace fallen {

/// A cell to draw, in frame `view`.
struct DrawnCell {
  Eigen::Vector3d mean;        ///< [m]
  Eigen::Matrix3d covariance;  ///< [m^2]
  Color color;                 ///< what it means, shaded by how its surface faces the light
};

/// All cells of the map, the farthest first.
std::vector<DrawnCell> CellsToDraw(const FrameResult& result, const Eigen::Isometry3d& T_view_map);

}  // namespace fallen
