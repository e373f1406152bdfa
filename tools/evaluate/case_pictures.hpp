// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/common/detector_setup.hpp"

namespace fallen {

/// A frame to draw.
struct CasePicture {
  std::string log;
  std::int64_t frame = 0;      ///< number in the recording, from 0
  std::filesystem::path file;  ///< PNG
};

/// Runs a fresh detector over each of the recordings, once, and saves the pictures of their frames
/// with the labelled boxes. Shows progress.
/// @throws std::runtime_error if a recording cannot be read or a picture not be written, and
/// always, unless there is nothing to draw, in a build without Cairo.
void DrawCases(const std::vector<CasePicture>& pictures, const DetectorOptions& detector, int jobs);

}  // namespace fallen
