// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/camera_intrinsics.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr int kMaxSide = 8192;  // far above any depth sensor, far below overflow of width * height

void RequireSide(const char* name, int side) {
  if (side >= 1 && side <= kMaxSide) return;
  throw std::invalid_argument(std::string("camera_intrinsics: ") + name + " is " +
                              std::to_string(side) + ", must be in [1, " +
                              std::to_string(kMaxSide) + "]");
}

void RequireFocalLength(const char* name, double pixels) {
  if (std::isfinite(pixels) && pixels > 0) return;
  throw std::invalid_argument(std::string("camera_intrinsics: ") + name + " is " +
                              std::to_string(pixels) + ", must be > 0 and finite");
}

void RequireFinite(const char* name, double pixels) {
  if (std::isfinite(pixels)) return;
  throw std::invalid_argument(std::string("camera_intrinsics: ") + name + " is " +
                              std::to_string(pixels) + ", must be finite");
}

}  // namespace

void CameraIntrinsics::Validate() const {
  RequireSide("width", width);
  RequireSide("height", height);
  RequireFocalLength("fx", fx);
  RequireFocalLength("fy", fy);
  RequireFinite("cx", cx);
  RequireFinite("cy", cy);
}

}  // namespace fallen
