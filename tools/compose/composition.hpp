// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "fallen/geometry/depth_image.hpp"
#include "tools/compose/person_cloud.hpp"

namespace fallen {

/// A depth image with somebody set into it.
struct Composition {
  DepthImage image;
  std::vector<std::uint8_t> is_person;  ///< one flag a pixel
  double visible_share = 0;  ///< of the person's points: inside the image and hidden by nothing
};

struct CompositionConfig {
  /// Disparity step of the sensor at 640 pixels of width [px], 0: depth is not quantised. The
  /// default is that of the PrimeSense family.
  double disparity_step_px = 0.125;
  double baseline_m = 0.075;  ///< between projector and camera
  /// See AddSensorNoise. The points' own noise is gone: a pixel's depth is a mean of several.
  double noise_scale = 1;
  std::uint64_t noise_seed = 1;
};

/// Sets a person into a scene: what is nearer hides the person, who hides what is farther. The
/// floor hides nobody, however noisy it is.
/// @param T_level_camera  See LevelFrameFromGround.
/// @param T_level_person  Where to; see Place::Pose.
Composition Compose(const DepthImage& scene, const Eigen::Isometry3d& T_level_camera,
                    const PersonCloud& person, const Eigen::Isometry3d& T_level_person,
                    const CompositionConfig& config = {});

}  // namespace fallen
