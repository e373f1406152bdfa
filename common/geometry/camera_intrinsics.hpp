// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace fallen {

/// Pinhole camera without distortion, pixels; optical frame: x right, y down, z forward.
///
/// Pixel centres have integer coordinates: pixel (u, v) with depth z is the point
/// ((u - cx) z / fx, (v - cy) z / fy, z).
struct CameraIntrinsics {
  int width = 0;
  int height = 0;
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;

  /// Point of pixel (`u`, `v`) at depth `z_m` along the optical axis, camera frame [m].
  Eigen::Vector3d Deproject(double u, double v, double z_m) const {
    return {(u - cx) * z_m / fx, (v - cy) * z_m / fy, z_m};
  }

  /// Pixel coordinates of a point in the camera frame; meaningless for z <= 0.
  Eigen::Vector2d Project(const Eigen::Vector3d& p_camera) const {
    return {fx * p_camera.x() / p_camera.z() + cx, fy * p_camera.y() / p_camera.z() + cy};
  }

  /// @throws std::invalid_argument unless sizes are in [1, 8192], focal lengths positive, all
  /// finite.
  void Validate() const;

  bool operator==(const CameraIntrinsics&) const = default;
};

}  // namespace fallen
