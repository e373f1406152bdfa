// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "fallen/geometry/depth_unit.hpp"

namespace fallen {

/// One of the ways in which a depth camera can work.
struct DepthMode {
  int width = 640;
  int height = 480;
  int rate_hz = 30;
  DepthUnit unit = DepthUnit::k1Mm;

  bool operator==(const DepthMode&) const = default;
};

/// "640x480 30 Hz 1mm".
std::string ToString(const DepthMode& mode);
/// "640x480 30 Hz 1mm, 320x240 30 Hz 1mm".
std::string ToString(std::span<const DepthMode> modes);

/// The camera is there but does not do what was asked of it: asking again is of no use.
class UnsupportedMode : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @throws UnsupportedMode naming the camera, what was wanted and all that there is.
void RequireSupported(const std::string& camera, const DepthMode& wanted,
                      std::span<const DepthMode> offered);

}  // namespace fallen
