// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/sensor_noise.hpp"

#include <cmath>

#include "tools/simulate/depth_sensor.hpp"
#include "tools/simulate/noise_field.hpp"

namespace fallen {

std::vector<double> AddSensorNoise(const std::vector<double>& depth_m,
                                   const CameraIntrinsics& camera, double scale,
                                   std::uint64_t seed) {
  if (scale <= 0) return depth_m;
  const sim::SensorConfig sensor = sim::NominalSensor(sim::SensorKind::kStructuredLight);
  const double width_ratio = camera.width / 640.0;
  const auto field = [&](std::uint64_t number) {
    return sim::NoiseField(sim::MixBits(seed) + number, camera.width, camera.height,
                           sensor.window_px * width_ratio);
  };
  const sim::NoiseField across_u = field(1), across_v = field(2), along = field(3);
  const double across_px = scale * sensor.lateral_noise_px * width_ratio;
  std::vector<double> noisy(depth_m.size(), 0);
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u, ++i) {
      const auto from_u = static_cast<int>(std::lround(u + across_px * across_u.At(u, v)));
      const auto from_v = static_cast<int>(std::lround(v + across_px * across_v.At(u, v)));
      if (from_u < 0 || from_v < 0 || from_u >= camera.width || from_v >= camera.height) continue;
      const double z_m = depth_m[static_cast<std::size_t>(from_v) * camera.width + from_u];
      if (z_m > 0) noisy[i] = z_m + scale * sim::AxialSigma(z_m, 0) * along.At(u, v);
    }
  return noisy;
}

}  // namespace fallen
