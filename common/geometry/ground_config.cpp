// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "fallen/geometry/ground_plane.hpp"

namespace fallen {
namespace {

template <class Value>
void Require(bool holds, const char* name, Value got, const char* expected) {
  if (holds) return;
  std::ostringstream message;
  message << "ground: " << name << " is " << got << ", must be " << expected;
  throw std::invalid_argument(message.str());
}

bool IsBetween(double value, double low, double high) { return value > low && value < high; }

}  // namespace

void GroundConfig::Validate() const {
  Require(EnumName(method) != "unknown", "method", static_cast<std::int32_t>(method),
          "auto, mounting, ransac or v_disparity");
  Require(IsBetween(inlier_distance_m, 0, 1), "inlier_distance_m", inlier_distance_m, "in (0, 1)");
  Require(IsBetween(max_tilt_deg, 0, 90), "max_tilt_deg", max_tilt_deg, "in (0, 90)");
  Require(IsBetween(max_mounting_error_deg, 0, 90), "max_mounting_error_deg",
          max_mounting_error_deg, "in (0, 90)");
  Require(max_mounting_error_m > 0 && std::isfinite(max_mounting_error_m), "max_mounting_error_m",
          max_mounting_error_m, "> 0 and finite");
  Require(min_camera_height_m > 0 && std::isfinite(min_camera_height_m), "min_camera_height_m",
          min_camera_height_m, "> 0 and finite");
  Require(max_camera_height_m > min_camera_height_m && std::isfinite(max_camera_height_m),
          "max_camera_height_m", max_camera_height_m, "> min_camera_height_m and finite");
  Require(IsBetween(min_inlier_fraction, 0, 1), "min_inlier_fraction", min_inlier_fraction,
          "in (0, 1)");
  Require(ransac_iterations >= 1 && ransac_iterations <= 1'000'000, "ransac_iterations",
          ransac_iterations, "in [1, 1000000]");
  Require(sample_points >= 100 && sample_points <= 10'000'000, "sample_points", sample_points,
          "in [100, 10000000]");
}

}  // namespace fallen
