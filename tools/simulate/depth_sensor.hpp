// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/geometry/depth_image.hpp"
#include "tools/simulate/ray_caster.hpp"

/// What a structured-light camera of the PrimeSense kind (Xtion, Carmine, Kinect 1) makes of a
/// scene.
///
/// [Nguyen12]    Nguyen, Izadi, Lovell: Modeling Kinect sensor noise for improved 3D reconstruction
/// and
///               tracking. 3DIMPVT 2012.
/// [Khoshelham12] Khoshelham, Elberink: Accuracy and resolution of Kinect depth data. Sensors 12,
/// 2012.
namespace fallen::sim {

struct SensorConfig {
  bool noise = true;  ///< false: the ideal image, for tests and figures
  /// Distance between projector and camera [m]: 7.5 cm [Khoshelham12].
  double baseline_m = 0.075;
  /// Focal length at which the sensor correlates [px]; whatever size it gives out.
  double correlation_focal_px = 575;
  /// Disparity is counted in these steps [px] [Khoshelham12].
  double disparity_step_px = 0.125;
  /// Depth is axial noise times this; 1 is [Nguyen12].
  double axial_noise_scale = 1;
  /// Lateral noise at 640 x 480 [px] [Nguyen12].
  double lateral_noise_px = 0.8;
  double min_range_m = 0.5;
  double max_range_m = 5.0;
};

/// Intrinsics of the sensor at a width of 640 or 320. @throws std::invalid_argument for another
/// width.
CameraIntrinsics SensorIntrinsics(int width);

struct SensorImage {
  DepthImage depth;                  ///< in millimetres
  std::vector<std::uint8_t> labels;  ///< 0 background, else 1 + index of the object
};

/// Takes a picture: lateral noise, axial noise, disparity steps, shadow of the projector, dropouts
/// where light comes back too weakly (grazing, dark, far) and at edges of depth, range limits.
/// Deterministic in `seed`. Thread-safe.
SensorImage TakePicture(const RayCaster& caster, const CameraIntrinsics& intrinsics,
                        const Eigen::Isometry3d& T_world_camera, const SensorConfig& config,
                        std::uint64_t seed);

/// Standard deviation of depth [m] at a distance and an angle of incidence [Nguyen12, Eq. 3].
double AxialSigma(double depth_m, double incidence_rad);

}  // namespace fallen::sim
