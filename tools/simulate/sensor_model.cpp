// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/sensor_model.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "tools/simulate/random.hpp"

namespace fallen::sim {
namespace {

constexpr double kXtionFocal = 575;
constexpr double kKinect2Focal = 456;  // 365 px at 512 x 424, cut and scaled to 640 x 480

// Draws deviations from nominal values, all of them, so that one more leaves the others alone.
class Deviation {
 public:
  Deviation(double variation, std::uint64_t seed, const char* name)
      : variation_(variation), random_(Random::Stream(seed, name)) {}

  double Add(double nominal, double low, double high) {
    return nominal + variation_ * (random_.Uniform(low, high) - nominal);
  }
  double Multiply(double nominal, double low, double high) {
    const double exponent = random_.Uniform(std::log(low), std::log(high));
    return nominal * std::exp(variation_ * exponent);
  }
  bool Chance(double probability) { return random_.Uniform() < variation_ * probability; }

 private:
  double variation_;
  Random random_;
};

void VaryCommon(double variation, std::uint64_t seed, SensorConfig& config) {
  Deviation draw(variation, seed, "sensor");
  config.axial_noise_scale = draw.Multiply(config.axial_noise_scale, 0.5, 2.2);
  config.weak_signal = draw.Multiply(config.weak_signal, 0.3, 4);
  config.edge_loss = draw.Add(config.edge_loss, 0.05, 0.9);
  const bool losing = draw.Chance(0.5);
  config.blob_loss = (losing ? 1 : 0) * draw.Multiply(0.005, 0.1, 6);
  config.depth_scale = draw.Add(1, 0.985, 1.015);
  config.depth_warp_m = draw.Add(0, 0, 0.0022);
  const bool bordered = draw.Chance(0.3);
  for (double& border : config.border_px) border = (bordered ? 1 : 0) * draw.Add(0, 0, 36);
}

void VaryStructuredLight(double variation, std::uint64_t seed, SensorConfig& config) {
  Deviation draw(variation, seed, "structured_light");
  config.min_range_m = draw.Add(config.min_range_m, 0.4, 0.8);
  config.max_range_m = draw.Add(config.max_range_m, 3.6, 6.5);
  config.lateral_noise_px = draw.Add(config.lateral_noise_px, 0.3, 1.6);
  config.window_px = draw.Add(config.window_px, 3, 9);
  if (draw.Chance(0.2)) config.disparity_step_px *= 2;
  if (draw.Chance(0.25)) config.baseline_m = -config.baseline_m;
}

void VaryTimeOfFlight(double variation, std::uint64_t seed, SensorConfig& config) {
  Deviation draw(variation, seed, "time_of_flight");
  config.max_range_m = draw.Add(config.max_range_m, 4.0, 5.0);
  config.flying_share = draw.Add(config.flying_share, 0.05, 0.9);
  config.multipath = draw.Add(config.multipath, 0, 0.3);
  config.wiggle_m = draw.Add(config.wiggle_m, 0, 0.008);
  config.intensity_bias_m = draw.Add(config.intensity_bias_m, -0.02, 0.03);
}

}  // namespace

SensorConfig NominalSensor(SensorKind kind) {
  SensorConfig config;
  config.kind = kind;
  if (kind == SensorKind::kTimeOfFlight) {
    config.max_range_m = 4.5;
    config.baseline_m = 0.01;  // light and lens are neighbours: next to no shadow
  }
  return config;
}

CameraIntrinsics SensorIntrinsics(int width, SensorKind kind) {
  if (width != 640 && width != 320)
    throw std::invalid_argument("sensor: width: got " + std::to_string(width) +
                                ", expected 320 or 640");
  const int height = width * 3 / 4;
  const double focal =
      (kind == SensorKind::kStructuredLight ? kXtionFocal : kKinect2Focal) * width / 640;
  return {width, height, focal, focal, (width - 1) / 2.0, (height - 1) / 2.0};
}

Sensor DrawSensor(SensorKind kind, int width, double variation, std::uint64_t seed) {
  Sensor sensor{NominalSensor(kind), SensorIntrinsics(width, kind)};
  sensor.config.device_seed = seed;
  VaryCommon(variation, seed, sensor.config);
  const bool structured = kind == SensorKind::kStructuredLight;
  (structured ? VaryStructuredLight : VaryTimeOfFlight)(variation, seed, sensor.config);
  Deviation draw(variation, seed, "intrinsics");
  CameraIntrinsics& k = sensor.intrinsics;
  const double scale = width / 640.0;
  const double focal =
      structured ? draw.Add(kXtionFocal, 500, 620) : draw.Add(kKinect2Focal, 430, 480);
  k.fx = focal * scale;
  k.fy = k.fx * draw.Add(1, 0.99, 1.01);
  k.cx += scale * draw.Add(0, -16, 16);
  k.cy += scale * draw.Add(0, -16, 16);
  return sensor;
}

}  // namespace fallen::sim
