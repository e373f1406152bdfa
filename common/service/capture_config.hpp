// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>

#include "fallen/geometry/depth_unit.hpp"

namespace fallen {

/// What fallen-depth-capture opens, and how the camera sits on the robot.
struct CaptureConfig {
  std::string device_uri;  ///< OpenNI2 URI as --list prints it, or an .oni file; empty: any device
  int width = 640;         ///< [px]
  int height = 480;        ///< [px]
  int rate_hz = 30;
  DepthUnit depth_unit = DepthUnit::k1Mm;
  /// Camera in the robot frame [m]: x forward, y left, z up from the floor. Unset: not known.
  std::optional<std::array<double, 3>> mounting_position_m;
  /// Turns of the camera's view direction [deg]: roll, pitch (positive looks down), yaw (left).
  /// Wanted with, and only with, a position.
  std::optional<std::array<double, 3>> mounting_roll_pitch_yaw_deg;
  /// A camera that is there but sends nothing for so long counts as lost [s], > 0. Starting up
  /// takes a PrimeSense camera about one second.
  double lost_after_s = 3;
  /// Time between attempts to open a lost camera [s], > 0: doubles from the first to the longest.
  double first_retry_s = 0.5;
  double longest_retry_s = 10;

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
  /// The mounting as a pose of the optical frame on the robot; nothing if it is not known.
  std::optional<Eigen::Isometry3d> T_robot_camera() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("device_uri", device_uri);
    visit("width", width);
    visit("height", height);
    visit("rate_hz", rate_hz);
    visit("depth_unit", depth_unit);
    visit("mounting_position_m", mounting_position_m);
    visit("mounting_roll_pitch_yaw_deg", mounting_roll_pitch_yaw_deg);
    visit("lost_after_s", lost_after_s);
    visit("first_retry_s", first_retry_s);
    visit("longest_retry_s", longest_retry_s);
  }
};

}  // namespace fallen
