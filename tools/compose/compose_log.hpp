// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <numbers>
#include <vector>

#include "tools/compose/composition.hpp"
#include "tools/compose/free_places.hpp"

namespace fallen {

struct ComposeOptions {
  std::filesystem::path person;  ///< cloud, PLY or PCD
  CloudUp up = CloudUp::kMinusY;
  double floor_cut_m = 0;       ///< see MakePersonCloud
  std::filesystem::path scene;  ///< any recording
  std::filesystem::path log;    ///< to write
  int frames = 10;              ///< of the scene to use, evenly spread
  int places = 3;               ///< a frame, at most
  PlaceSearch search{1.5, 3.5, {-std::numbers::pi / 4, 0, std::numbers::pi / 4}};
  /// Of the person's points; less is left out.
  double min_visible_share = 0.7;
  CompositionConfig composition;
  std::uint64_t seed = 1;
};

struct ComposeReport {
  int used_frames = 0;    ///< of the scene
  int without_floor = 0;  ///< of these: nothing was set in
  int without_place = 0;  ///< likewise, though there is a floor
  int images = 0;         ///< written
};

/// Sets a person into frames of a scene, each time at one free place, and writes a log with ground
/// truth: pose, mounting (both of the estimated floor), box, label image and depth image.
///
/// Images stand alone: they are so far apart in time that no map accumulates over them. World is
/// the level frame of each image.
/// @throws std::runtime_error naming the file that cannot be read or written, or if no place was
/// found.
ComposeReport ComposeLog(const ComposeOptions& options);

}  // namespace fallen
