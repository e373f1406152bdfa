// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace fallen {

/// A box that stands upright and is turned about the vertical: labels and detections.
struct OrientedBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();    ///< full edge lengths along its own axes [m]
  double yaw = 0;                                    ///< about +z, from x to y [rad]

  /// True if `p` lies inside or on the surface.
  bool Contains(const Eigen::Vector3d& p) const;

  bool operator==(const OrientedBox&) const = default;
};

}  // namespace fallen
