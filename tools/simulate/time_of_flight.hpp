// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tools/simulate/noise_field.hpp"
#include "tools/simulate/ray_caster.hpp"
#include "tools/simulate/sensor_model.hpp"

namespace fallen::sim {

/// Depth as a camera measures it that times modulated light [Sarbolandi15]. Keeps references.
class TimeOfFlight {
 public:
  TimeOfFlight(const IdealView& view, const CameraIntrinsics& intrinsics,
               const SensorConfig& config, std::uint64_t seed);

  /// What the camera makes of `depth` [m] in a pixel that the ideal view has.
  double Measure(int u, int v, double depth) const;

 private:
  /// How far a corner seems farther away by light that came round it [m].
  double MultipathBias(int u, int v, double depth) const;

  const IdealView& view_;
  const CameraIntrinsics& intrinsics_;
  const SensorConfig& config_;
  std::uint64_t own_seed_, flying_seed_;
  NoiseField shared_;
  /// Sums over the rectangle above and to the left: of inverse depth, and of pixels that have one.
  std::vector<double> inverse_sums_;
  std::vector<int> count_sums_;
};

/// Standard deviation of depth [m] where light comes back with `signal` (albedo * cosine /
/// depth^2).
double TimeOfFlightSigma(double signal);

}  // namespace fallen::sim
