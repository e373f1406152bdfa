// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/ndt/ndt_mapper.hpp"
#include "ray_cast_scene.hpp"

/// What the tests of the mapper look at.
namespace fallen {

inline const GroundEstimate kNoGround;

/// The floor z = 0, or that through `origin`, as a camera sees it.
inline GroundEstimate FloorSeenFrom(const Eigen::Isometry3d& T_world_camera,
                                    const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  GroundEstimate ground;
  ground.status = GroundStatus::kOk;
  ground.plane = TransformPlane(T_world_camera.inverse(), Plane{{0, 0, 1}, -origin.z()});
  return ground;
}

/// Furniture and a person on the floor.
inline RayCastScene RoomWithPerson() {
  RayCastScene scene = FurnishedRoom();
  scene.ellipsoids = LyingPerson({2.2, 0, 0}, 0.6);
  return scene;
}

}  // namespace fallen
