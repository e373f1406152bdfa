// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fallen/detection/frame.hpp"
#include "fallen/geometry/oriented_box.hpp"

/// A room for tests: a floor, a wall 3.5 m ahead, and, if wanted, a block of a lying person's size.
namespace fallen::lying_scene {

inline constexpr double kCameraHeightM = 1.0;

/// The block, world frame.
OrientedBox Person();

/// The camera's pose: level robot at `robot_x` on the x axis that looks along it, 15 degrees down.
Eigen::Isometry3d CameraPose(double robot_x);

enum class With { kNobody, kPerson };

/// The room without noise, from a camera at `robot_x`, 320 x 240. With mounting and pose.
Frame Render(std::int64_t utime, double robot_x, With with);

/// Writes a recording directory of the room: `frames` at 10 Hz, 2 cm apart. With poses if wanted.
void WriteDirectory(const std::filesystem::path& directory, int frames, With with, bool with_poses);

/// Writes its labels.yaml: the block with 2 cm around it, or nobody.
void WriteLabels(const std::filesystem::path& directory, With with);

}  // namespace fallen::lying_scene
