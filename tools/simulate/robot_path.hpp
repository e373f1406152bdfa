// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "tools/simulate/column_grid.hpp"
#include "tools/simulate/random.hpp"

namespace fallen::sim {

/// Where a robot stands: origin on the floor between its wheels, x ahead.
struct RobotPose {
  double x = 0, y = 0, yaw = 0;
};

struct PathConfig {
  int frames = 60;
  double rate_hz = 10;
  double max_speed_m_s = 0.6;
  double max_turn_rad_s = 0.8;
  double robot_radius_m = 0.28;
  double robot_height_m = 1.3;
  double half_field_of_view_rad = 0.507;  ///< horizontal: atan(320 / 575)
  double half_vertical_view_rad = 0.39;   ///< atan(240 / 575)
  double camera_height_m = 1.1;
  double camera_pitch_rad = 0.44;  ///< downwards
  double target_height_m = 0.1;    ///< of the target's middle
  /// From the target's middle to one end, for drives that see one end while something stands before
  /// the other; without, drives see the middle.
  std::optional<Eigen::Vector2d> half_hidden;
};

/// A drive like that of a differential-drive robot through free space.
///
/// With a target, many drives are tried and the one kept that has it in view the longest, from
/// different sides and distances; without, the robot roams. No pose collides with what `grid`
/// holds; where the room is too full to stand anywhere the least blocked place is kept.
std::vector<RobotPose> DrawPath(const PathConfig& config, const ColumnGrid& grid,
                                const Eigen::Vector2d& room_size,
                                const std::optional<Eigen::Vector2d>& target, Random& random);

}  // namespace fallen::sim
