// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "fallen/ndt/ndt_map.hpp"

namespace fallen {

/// Frame `view` of a map: origin on the floor below the camera, x ahead, z up. Left and right in it
/// are those of the depth image. Without a floor, the camera is taken to be level, at its own
/// height 0.
Eigen::Isometry3d ViewFromMap(MapFrame frame, const Eigen::Isometry3d& T_map_camera);

/// Looks at frame `view` from behind and above the camera, without perspective.
class ObliqueView {
 public:
  /// @param pixels_per_m  Scale.
  /// @param origin        Where the origin of frame `view` comes to lie [px].
  ObliqueView(double pixels_per_m, const Eigen::Vector2d& origin);

  /// Pixels, y down.
  Eigen::Vector2d Project(const Eigen::Vector3d& p_view) const;
  /// Covariance in pixels of one in metres.
  Eigen::Matrix2d ProjectCovariance(const Eigen::Matrix3d& covariance_view) const;
  /// Larger is farther away: what is drawn first.
  static double Depth(const Eigen::Vector3d& p_view);

 private:
  Eigen::Matrix<double, 2, 3> projection_;
  Eigen::Vector2d origin_;
};

}  // namespace fallen
