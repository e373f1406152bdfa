// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace fallen {

/// Reads the values of a 16-bit greyscale PNG of `width` x `height`, row-major.
/// @throws InputError if the file is not there, is no such PNG, or is damaged.
std::vector<std::uint16_t> ReadDepthPng(const std::filesystem::path& file, int width, int height);

}  // namespace fallen
