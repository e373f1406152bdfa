// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/simulate/simulation.hpp"

namespace fallen::sim {

struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< RGB, row-major
};

/// Some frames of a recording, each as coloured depth beside grey depth tinted by label (the person
/// red), and below them the room with the drive from above and the person from near.
RgbImage DrawPreview(const Simulation& simulation, int frames);

/// A mesh in parallel projection, shaded; `from_above` or from -y. For a look at bodies and
/// furniture.
RgbImage DrawMesh(const Scene& scene, bool from_above, const Eigen::Vector2d& center,
                  double extent_m, int size_px);

/// Puts `image` into `sheet` with its upper left corner at (x, y); what sticks out is cut off.
void Paste(const RgbImage& image, int x, int y, RgbImage& sheet);

/// @throws std::runtime_error if the file cannot be written.
void WritePng(const std::filesystem::path& path, const RgbImage& image);

}  // namespace fallen::sim
