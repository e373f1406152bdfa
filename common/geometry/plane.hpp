// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fallen {

/// The points p with normal . p + offset = 0; `normal` is a unit vector.
///
/// For a ground plane the normal points up, so that `SignedHeight` is the height above the floor.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;

  /// Distance of `p` from the plane [m], positive on the side that the normal points to.
  double SignedHeight(const Eigen::Vector3d& p) const { return normal.dot(p) + offset; }

  bool operator==(const Plane&) const = default;
};

/// The same plane in the frame `target`.
inline Plane TransformPlane(const Eigen::Isometry3d& T_target_source, const Plane& plane_source) {
  const Eigen::Vector3d normal = T_target_source.linear() * plane_source.normal;
  return {normal, plane_source.offset - normal.dot(T_target_source.translation())};
}

}  // namespace fallen
