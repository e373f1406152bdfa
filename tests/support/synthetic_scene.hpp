// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>

#include "fallen/messages/conversions.hpp"

/// A small scene with known geometry: a robot drives towards something that lies on a floor.
namespace fallen::testing_support {

inline constexpr std::int64_t kFirstUtime = 1'700'000'000'000'000;
inline constexpr std::int64_t kFrameInterval_us = 33'333;  // 30 Hz

/// Camera of the scene in the robot frame: 0.95 m above the floor, looks down by 20 degrees.
Eigen::Isometry3d SceneMounting();

/// Robot at `utime`: along x with 0.3 m/s, turning slowly.
StampedPose ScenePose(std::int64_t utime);

/// Depth image `seq`, 320 x 240, of floor z = 0 and an ellipsoid of a person's length 2.2 m ahead;
/// quantised to millimetres, without noise.
StampedDepthImage SceneImage(std::int64_t seq, const std::string& camera = "CAMERA");

/// A log of `frames` depth images and of poses at 50 Hz, in order of time.
void WriteSceneLog(const std::filesystem::path& path, int frames);

}  // namespace fallen::testing_support
