// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/geometry/depth_image.hpp"
#include "tools/simulate/ray_caster.hpp"
#include "tools/simulate/sensor_model.hpp"

/// What a depth camera makes of a scene. References: see sensor_model.hpp.
namespace fallen::sim {

struct SensorImage {
  DepthImage depth;                  ///< in millimetres
  std::vector<std::uint8_t> labels;  ///< 0 background, else 1 + index of the object
};

/// Takes a picture.
///
/// Structured light: lateral noise, axial noise, disparity steps, shadow of the projector. Time of
/// flight: noise that grows as light returns weaker, pixels that fly between near and far, corners
/// that seem too far away. Both: losses where light comes back too weakly (grazing, dark, far), at
/// edges of depth and in blobs, errors of calibration, range limits.
/// Deterministic in `seed`. Thread-safe.
SensorImage TakePicture(const RayCaster& caster, const CameraIntrinsics& intrinsics,
                        const Eigen::Isometry3d& T_world_camera, const SensorConfig& config,
                        std::uint64_t seed);

/// Standard deviation of structured-light depth [m] at a distance and an angle of incidence
/// [Nguyen12, Eq. 3].
double AxialSigma(double depth_m, double incidence_rad);

}  // namespace fallen::sim
