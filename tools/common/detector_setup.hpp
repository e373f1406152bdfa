// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fallen/detection/detector.hpp"

namespace CLI {
class App;
}

namespace fallen {

/// What the command line says about the detector.
struct DetectorOptions {
  std::optional<std::filesystem::path> config;  ///< nothing: all defaults
  std::string model;                            ///< empty: the configuration's, else the shipped
  std::string environment_map;                  ///< empty: the configuration's, else none
};

/// Adds --config, --model and --map.
void AddDetectorOptions(CLI::App& parser, DetectorOptions& options);

/// What a detector is made of.
struct DetectorParts {
  Model model;
  DetectorConfig config;
  BackgroundSubtractor background;
};

/// Loads the parts of a configuration's detector.
/// @throws std::runtime_error naming the file that is missing, damaged or does not fit.
DetectorParts LoadDetectorParts(const DetectorOptions& options);

/// Makes the detector of a configuration, as the services are set up by it.
/// @throws std::runtime_error naming the file that is missing, damaged or does not fit.
Detector MakeDetector(const DetectorOptions& options);

}  // namespace fallen
