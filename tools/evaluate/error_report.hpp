// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "tools/common/detector_setup.hpp"
#include "tools/evaluate/error_cases.hpp"

namespace fallen {

/// What the page says above the cases.
struct ErrorReportHead {
  std::int64_t recordings = 0;
  std::int64_t frames = 0;
  double min_probability = 0;  ///< threshold in force
};

/// Writes a folder to look through: `index.html`, which needs nothing from elsewhere, `cases.json`,
/// and a picture of each case: the depth image beside the NDT map, cells by score, the labelled box
/// and all detections. Shows progress.
/// @param detector  That was measured; it runs again over the recordings of the cases.
/// @throws std::runtime_error if something cannot be read or written, or this build is without
/// Cairo and cannot draw.
void WriteErrorReport(const std::filesystem::path& folder, const WorstCases& worst,
                      const ErrorReportHead& head, const DetectorOptions& detector, int jobs);

/// Name of the picture of a case in its folder: "miss-01.png", "false-alarm-12.png".
std::string PictureName(bool is_miss, std::size_t rank);

/// The page, as WriteErrorReport writes it.
std::string ErrorPage(const WorstCases& worst, const ErrorReportHead& head);

}  // namespace fallen
