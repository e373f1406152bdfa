// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <random>
#include <vector>

#include "fallen/geometry/depth_image.hpp"

namespace fallen {

/// A box along the axes of the world.
struct SceneBox {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

/// An ellipsoid about `center`: `to_unit_sphere` maps offsets from there to the unit sphere.
struct SceneEllipsoid {
  Eigen::Vector3d center;
  Eigen::Matrix3d to_unit_sphere;
};

/// A world simple enough to be intersected by hand: floor at z = 0, boxes, ellipsoids.
struct RayCastScene {
  bool has_floor = true;
  std::vector<SceneBox> boxes;
  std::vector<SceneEllipsoid> ellipsoids;

  /// Smallest t > 0 at which `origin + t * direction` meets something.
  std::optional<double> Intersect(const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction) const;
};

/// Depth image of the scene in millimetres, without noise.
DepthImage RenderDepth(const RayCastScene& scene, const CameraIntrinsics& intrinsics,
                       const Eigen::Isometry3d& T_world_camera);

/// The image as a PrimeSense-type sensor would have taken it: axial noise (Nguyen 2012), then
/// disparity in steps of 1/8 pixel at a baseline of 75 mm.
DepthImage WithSensorNoise(DepthImage image, std::mt19937& generator);

/// Pinhole camera with the field of view of PrimeSense-type sensors (f = 575 at 640 x 480).
CameraIntrinsics PrimeSenseIntrinsics(int width, int height);

/// Pose of a camera at `position` that looks horizontally along `yaw_rad`, tilted down by
/// `pitch_rad`.
Eigen::Isometry3d LookingDown(const Eigen::Vector3d& position, double yaw_rad, double pitch_rad);

/// Person-sized ellipsoids lying on the floor around `center`: head, trunk, arms, legs.
std::vector<SceneEllipsoid> LyingPerson(const Eigen::Vector3d& center, double yaw_rad);

/// A furnished room, 6 m x 5 m, seen from near its origin: walls, a table, a sofa, a cupboard.
RayCastScene FurnishedRoom();

}  // namespace fallen
