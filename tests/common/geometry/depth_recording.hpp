// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fallen/geometry/depth_image.hpp"

namespace fallen::testing {

struct RecordedFrame {
  DepthImage image;
  std::optional<Eigen::Isometry3d> T_world_camera;
};

/// Reads a directory in the style of TUM RGB-D: `depth.txt`, 16-bit PNGs, `camera.yaml`, and
/// `groundtruth.txt` if it is there. Empty if the directory is not there.
/// @throws std::runtime_error if a file is broken.
std::vector<RecordedFrame> ReadRecording(const std::filesystem::path& directory);

}  // namespace fallen::testing
