// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fallen/detection/detector.hpp"

namespace fallen {

/// What a detector decided about a frame of a drive, and what was really there.
struct TracedFrame {
  std::int64_t utime = 0;
  Decision decision;
  std::optional<OrientedBox> person_box;  ///< of the fallen person, world frame
  /// At least 100 cells of the local map are in the box: the paper's measure of "present".
  bool is_in_view = false;
};

/// A drive as the alarm gets to know it.
struct DriveTrace {
  std::string log;
  std::string camera;
  std::vector<TracedFrame> frames;
};

/// Runs `detector`, a fresh one, over a recording with poses and ground truth.
/// @throws std::runtime_error if the input cannot be read or holds no ground truth.
DriveTrace TraceDrive(const std::filesystem::path& input, Detector detector);

}  // namespace fallen
