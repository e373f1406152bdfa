// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/geometry/camera_intrinsics.hpp"

namespace fallen {

/// One depth picture as the sensor gives it: the input of the whole chain.
///
/// Invariant (checked by `Validate`): `depth.size() == intrinsics.width * intrinsics.height`.
struct DepthImage {
  CameraIntrinsics intrinsics;
  /// Metres per unit of `depth`, > 0 (0.001 for millimetres, 0.0001 for OpenNI's DEPTH_100_UM).
  double depth_unit_m = 0.001;
  /// Row-major, z along the optical axis in units of `depth_unit_m`; 0 means "no measurement".
  std::vector<std::uint16_t> depth;

  /// @throws std::invalid_argument if a size, unit or intrinsic parameter makes no sense.
  void Validate() const;
};

}  // namespace fallen
