// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fallen {

/// What fallen-map is asked to build.
struct BuildMapOptions {
  std::vector<std::filesystem::path> inputs;  ///< recordings and clouds, all in the same world
  std::filesystem::path output;
  std::optional<std::filesystem::path> config;
  std::optional<std::string> camera;       ///< of the logs
  std::optional<double> cell_size_m;       ///< nothing: the configuration's
  std::optional<std::string> description;  ///< nothing: what it was built from
};

struct BuildMapReport {
  std::int64_t frames = 0;  ///< of recordings
  std::int64_t frames_without_pose = 0;
  std::int64_t damaged = 0;
  std::int64_t points = 0;  ///< of clouds, between floor and greatest height
  std::size_t cells = 0;
};

/// Builds an environment map of recordings and clouds and saves it.
/// @throws std::runtime_error naming the input that is of no use.
BuildMapReport BuildMap(const BuildMapOptions& options);

}  // namespace fallen
