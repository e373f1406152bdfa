// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "fallen/geometry/plane.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "fallen/ndt/voxel_store.hpp"

namespace fallen {

/// The camera in the voxel grid. Places are told relative to the voxel that the camera is in, so
/// that they keep their digits far from the origin of the map.
struct GridCamera {
  VoxelIndex voxel;
  Eigen::Matrix3d R_map_camera;
  Eigen::Vector3d position;  ///< of the camera, from the corner of that voxel [m]
  double cell_size_m;

  GridCamera(const Eigen::Isometry3d& T_map_camera, double cell_size)
      : R_map_camera(T_map_camera.linear()), cell_size_m(cell_size) {
    const Eigen::Array3d index = (T_map_camera.translation().array() / cell_size).floor();
    voxel = {static_cast<std::int32_t>(index.x()), static_cast<std::int32_t>(index.y()),
             static_cast<std::int32_t>(index.z())};
    position = (T_map_camera.translation().array() - index * cell_size).matrix();
  }

  /// Centre of a voxel relative to the camera, along the axes of the map [m].
  Eigen::Vector3d CenterFromCamera(const VoxelIndex& index) const {
    const Eigen::Vector3d steps(index.x - voxel.x, index.y - voxel.y, index.z - voxel.z);
    return (steps.array() + 0.5).matrix() * cell_size_m - position;
  }

  /// Mean of a voxel's points relative to the camera, along the axes of the map [m].
  Eigen::Vector3d MeanFromCamera(const Voxel& v) const {
    return CenterFromCamera(v.index) +
           Eigen::Vector3d(v.moments.mean[0], v.moments.mean[1], v.moments.mean[2]);
  }
};

/// What is the floor's and what is too high, by a point relative to the camera (axes of the map).
struct HeightLimits {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  double camera_height_m = 0;
  /// Without a floor, every point is at height 0 and within the limits.
  double clearance_m = -1, clearance_per_sq_m = 0, max_height_m = 1;

  HeightLimits() = default;
  HeightLimits(const Plane& ground_camera, const Eigen::Matrix3d& R_map_camera,
               const NdtConfig& config)
      : up(R_map_camera * ground_camera.normal),
        camera_height_m(ground_camera.offset),
        clearance_m(config.ground_clearance_m),
        clearance_per_sq_m(config.ground_clearance_per_sq_m),
        max_height_m(config.max_height_m) {}

  double HeightOf(const Eigen::Vector3d& from_camera) const {
    return up.dot(from_camera) + camera_height_m;
  }
};

}  // namespace fallen
