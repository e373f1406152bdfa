// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenNI.h>

#include <optional>
#include <string>
#include <vector>

#include "services/depth_capture/depth_mode.hpp"
#include "services/depth_capture/raw_depth_frame.hpp"

/// OpenNI2's types to ours and back. Includes OpenNI.h: meant for .cpp files.
namespace fallen {

/// OpenNI2's own words about the last failure, on one line, or `otherwise` if it has none.
std::string OpenNiError(const std::string& otherwise);

/// Nothing for a pixel format that holds no depth (raw shifts).
std::optional<DepthMode> FromOpenNi(const openni::VideoMode& mode);
openni::VideoMode ToOpenNi(const DepthMode& mode);

/// Depth modes of an open device, each once.
std::vector<DepthMode> DepthModesOf(openni::Device& device);

/// View of a frame's memory: valid as long as the frame.
/// @throws BadFrame if it holds no depth.
RawDepthFrame ViewOf(const openni::VideoFrameRef& frame);

FieldOfView FieldOfViewOf(const openni::VideoStream& stream);

}  // namespace fallen
