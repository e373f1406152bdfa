// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "fallen/detection/detector.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

/// Runs the detector over a recording and saves the pictures of all frames as a film, at the rate
/// of the recording's first two frames.
/// @param name  Of the recording, for the pictures and for errors.
/// @return How many frames it has. @throws std::runtime_error if there is none, or as FilmWriter.
std::int64_t SaveFilm(const std::filesystem::path& film, FrameSource& recording, Detector& detector,
                      const std::string& name);

}  // namespace fallen
