// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fallen/detection/detector.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/picture/viewed_frame.hpp"

namespace fallen {

/// Which frame to look at.
struct FrameChoice {
  std::optional<std::int64_t> index;  ///< nothing: the one with the highest probability
};

/// "best" or a number from 0. @throws std::invalid_argument for anything else.
FrameChoice ParseFrameChoice(const std::string& text);

/// Runs the detector over the recording, up to the chosen frame or to the end, and returns that
/// frame. The first of several best; the first frame if no cluster was found in any.
/// @param name  Of the recording, for the picture and for errors.
/// @throws std::runtime_error if there is no such frame.
ViewedFrame FindFrame(FrameSource& recording, Detector& detector, const FrameChoice& choice,
                      const std::string& name);

}  // namespace fallen
