// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

namespace fallen {

/// What fallen-depth-capture opens, and how the camera sits on the robot.
struct CaptureConfig {
  std::string device_uri;  ///< OpenNI2 URI as --list prints it, or an .oni file; empty: any device
  int width = 640;         ///< [px]
  int height = 480;        ///< [px]
  int rate_hz = 30;
  /// Camera in the robot frame [m]: x forward, y left, z up from the floor. Unset: not known.
  std::optional<std::array<double, 3>> mounting_position_m;
  /// Turns of the camera's view direction [deg]: roll, pitch (positive looks down), yaw (left).
  /// Wanted with, and only with, a position.
  std::optional<std::array<double, 3>> mounting_roll_pitch_yaw_deg;

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("device_uri", device_uri);
    visit("width", width);
    visit("height", height);
    visit("rate_hz", rate_hz);
    visit("mounting_position_m", mounting_position_m);
    visit("mounting_roll_pitch_yaw_deg", mounting_roll_pitch_yaw_deg);
  }
};

}  // namespace fallen
