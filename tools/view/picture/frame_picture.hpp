// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "tools/view/picture/viewed_frame.hpp"

namespace fallen {

/// Saves a picture of a frame: the depth image beside the NDT map, with what was found in it.
/// @throws std::runtime_error if the file cannot be written.
void SaveFramePicture(const std::filesystem::path& png, const ViewedFrame& viewed);

/// What is known about the frame, in one line: floor, map, clusters, time.
std::string DescribeFrame(const ViewedFrame& viewed);

}  // namespace fallen
