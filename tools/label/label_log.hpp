// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/common/detector_setup.hpp"

namespace fallen {

struct LabelOptions {
  std::filesystem::path log;
  std::filesystem::path truth;  ///< labels.yaml, see LabelFile
  std::filesystem::path output;
  std::optional<std::string> camera;  ///< nothing: the log's only one
  DetectorOptions detector;           ///< its ground and map are what boxes are checked against
};

/// What became of the labels.
struct LabelReport {
  std::int64_t frames = 0;
  std::int64_t labelled = 0;
  std::int64_t with_person = 0;  ///< of them, somebody lies there
  std::int64_t positive = 0;     ///< and counts as present: 100 cells in the box (Sec. IV-B)
  /// Frames to look at: first, middle and last of each stretch.
  std::vector<std::int64_t> frames_to_show;
};

/// Writes a copy of a log in which the depth images of a camera have the ground truth of a label
/// file; what truth the log had of them is left out. The copy appears only once it is complete.
/// Shows progress.
/// @throws std::runtime_error for input that cannot be used, a stretch without a frame, and a box
/// without a cell of the map in any frame of its stretch, naming file and line.
LabelReport LabelLog(const LabelOptions& options);

}  // namespace fallen
