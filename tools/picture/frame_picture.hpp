// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "tools/picture/canvas.hpp"
#include "tools/picture/viewed_frame.hpp"

namespace fallen {

/// Size of a frame's picture [px]: a 4:3 depth image fills its panel, like the map its own. Even,
/// as films want it.
inline constexpr int kPictureWidth = 1600;
inline constexpr int kPictureHeight = 726;

/// Draws a frame: the depth image beside the NDT map, with what was found in it.
/// @param canvas  Of a picture's size, blank.
void DrawFramePicture(Canvas& canvas, const ViewedFrame& viewed);

/// Saves the picture of a frame as PNG.
/// @throws std::runtime_error if the file cannot be written.
void SaveFramePicture(const std::filesystem::path& png, const ViewedFrame& viewed);

/// What is known about the frame, in one line: floor, map, clusters, time.
std::string DescribeFrame(const ViewedFrame& viewed);

}  // namespace fallen
