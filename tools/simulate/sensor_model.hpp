// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "fallen/geometry/camera_intrinsics.hpp"
#include "fallen/geometry/enum_names.hpp"

/// Which camera takes the pictures, and how this copy of it differs from its data sheet.
///
/// [Nguyen12]     Nguyen, Izadi, Lovell: Modeling Kinect sensor noise for improved 3D
///                reconstruction and tracking. 3DIMPVT 2012.
/// [Khoshelham12] Khoshelham, Elberink: Accuracy and resolution of Kinect depth data. Sensors 12,
///                2012.
/// [Sarbolandi15] Sarbolandi, Lefloch, Kolb: Kinect range sensing: structured-light versus
///                time-of-flight Kinect. CVIU 139, 2015.
namespace fallen::sim {

enum class SensorKind {
  kStructuredLight,  ///< PrimeSense: Xtion, Carmine, Kinect 1
  kTimeOfFlight,     ///< Kinect 2
};
constexpr auto EnumNames(SensorKind) {
  return EnumTable<SensorKind, 2>{{{SensorKind::kStructuredLight, "structured_light"},
                                   {SensorKind::kTimeOfFlight, "time_of_flight"}}};
}

/// Lengths in pixels are at a width of 640, whatever the picture's.
struct SensorConfig {
  SensorKind kind = SensorKind::kStructuredLight;
  bool noise = true;              ///< false: the ideal image, for tests and figures
  std::uint64_t device_seed = 0;  ///< of what stays with the copy: its calibration errors
  double min_range_m = 0.5;
  double max_range_m = 5.0;
  /// Times the model's noise along the ray: [Nguyen12] for structured light.
  double axial_noise_scale = 1;
  /// Signal (albedo * cosine of incidence / depth^2) at which a pixel is as likely lost as not.
  /// 0.0018: of a matt floor (0.45), 1 m below the camera, some 5 % are lost at 4.5 m, as in real
  /// recordings of a Kinect.
  double weak_signal = 0.0018;
  double edge_loss = 0.35;   ///< share of pixels without depth where depth jumps
  double blob_loss = 0;      ///< share lost in blobs for no reason in the scene: gloss, daylight
  double depth_scale = 1;    ///< calibration: measured by true depth
  double depth_warp_m = 0;   ///< calibration: standard deviation at 1 m; grows with depth^2
  double border_px[4] = {};  ///< without depth: left, top, right, bottom, as registration leaves it

  // Structured light.
  /// From camera to projector [m]: 7.5 cm [Khoshelham12]. Negative in a mirrored picture.
  double baseline_m = 0.075;
  /// Focal length at which the sensor correlates [px]; whatever size it gives out.
  double correlation_focal_px = 575;
  double disparity_step_px = 0.125;  ///< [Khoshelham12]
  double lateral_noise_px = 0.8;     ///< [Nguyen12]
  /// Correlation windows overlap from pixel to pixel, so errors and losses are alike within so many
  /// pixels. In real recordings less than 1 % of the missing pixels stand alone.
  double window_px = 5;

  // Time of flight [Sarbolandi15].
  double flying_share = 0.5;    ///< of the edge pixels that mix near and far
  double multipath = 0.1;       ///< of the depth by which a corner lies behind its surroundings
  double wiggle_m = 0.003;      ///< amplitude of the error that is periodic in depth
  double intensity_bias_m = 0;  ///< from a white surface to a black one
};

/// A sensor that is as its data sheet says.
SensorConfig NominalSensor(SensorKind kind);

/// Intrinsics of the nominal sensor at a width of 640 or 320.
/// @throws std::invalid_argument for another width.
CameraIntrinsics SensorIntrinsics(int width, SensorKind kind = SensorKind::kStructuredLight);

struct Sensor {
  SensorConfig config;
  CameraIntrinsics intrinsics;
};

/// A copy of the sensor, spread about the nominal one wider than real copies are: focal length,
/// principal point, noise, losses, calibration, range. `variation` 0 gives the nominal one, 1 the
/// whole spread.
Sensor DrawSensor(SensorKind kind, int width, double variation, std::uint64_t seed);

}  // namespace fallen::sim
