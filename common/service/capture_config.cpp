// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/capture_config.hpp"

#include <stdexcept>

#include "fallen/geometry/mounting.hpp"

namespace fallen {
namespace {

constexpr int kMaxImageSize = 8192;  // as CameraIntrinsics
constexpr int kMaxRateHz = 1000;

void RequireRange(const char* name, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(std::string("capture: ") + name + " is " + std::to_string(value) +
                              ", must be in [" + std::to_string(low) + ", " + std::to_string(high) +
                              "]");
}

void RequirePositive(const char* name, double value) {
  if (value > 0) return;
  throw std::invalid_argument(std::string("capture: ") + name + " is " + std::to_string(value) +
                              ", must be > 0");
}

}  // namespace

void CaptureConfig::Validate() const {
  RequireRange("width", width, 1, kMaxImageSize);
  RequireRange("height", height, 1, kMaxImageSize);
  RequireRange("rate_hz", rate_hz, 1, kMaxRateHz);
  if (mounting_position_m.has_value() != mounting_roll_pitch_yaw_deg.has_value())
    throw std::invalid_argument(
        "capture: mounting_position_m and mounting_roll_pitch_yaw_deg must be given together");
  RequirePositive("lost_after_s", lost_after_s);
  RequirePositive("first_retry_s", first_retry_s);
  if (!(longest_retry_s >= first_retry_s))
    throw std::invalid_argument("capture: longest_retry_s is " + std::to_string(longest_retry_s) +
                                ", must be at least first_retry_s");
}

std::optional<Eigen::Isometry3d> CaptureConfig::T_robot_camera() const {
  if (!mounting_position_m || !mounting_roll_pitch_yaw_deg) return std::nullopt;
  return T_robot_cameraFromMounting(*mounting_position_m, *mounting_roll_pitch_yaw_deg);
}

}  // namespace fallen
