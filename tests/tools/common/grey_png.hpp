// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace fallen {

/// How a test's PNG is coded.
struct PngFormat {
  int bit_depth = 16;
  bool colour = false;
  bool interlaced = false;
};

/// Writes a greyscale PNG for tests; 8-bit ones get the low bytes, coloured ones three equal
/// values.
void WriteGreyPng(const std::filesystem::path& file, int width, int height,
                  const std::vector<std::uint16_t>& values, const PngFormat& format = {});

}  // namespace fallen
