// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/geometry/camera_intrinsics.hpp"

namespace fallen {

/// A rendered image as a structured-light camera measures it: with noise along the ray and across,
/// alike within a window, of the size that sim::SensorConfig has. Disparity steps are not applied.
/// @param depth_m  A value a pixel, row by row [m]; 0: nothing there, which stays so but for
///                 outlines, which the noise across frays.
/// @param scale    Times the noise of the nominal camera; 0 gives the image back.
/// Deterministic in `seed`.
std::vector<double> AddSensorNoise(const std::vector<double>& depth_m,
                                   const CameraIntrinsics& camera, double scale,
                                   std::uint64_t seed);

}  // namespace fallen
