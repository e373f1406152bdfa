// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fallen {

/// What has been written.
struct ImportReport {
  std::int64_t frames = 0;
  std::int64_t poses = 0;
  std::int64_t labelled = 0;  ///< frames with ground truth
};

/// Writes a directory as a log. For each frame, at its time: pose of the robot and ground truth,
/// where known, then the depth image. The log appears only once it is complete.
/// @throws std::runtime_error for bad input (as ReadTumDirectory) or an output that cannot be
/// written.
ImportReport ImportDirectory(const std::filesystem::path& directory,
                             const std::filesystem::path& log, const std::string& camera);

}  // namespace fallen
