// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fallen/detection/detector.hpp"
#include "fallen/geometry/enum_names.hpp"

namespace CLI {
class App;
}

namespace fallen {

/// A way to set up the method that is kept beside the shipped one.
enum class Preset : std::int32_t {
  kPaper = 0,  ///< the method as the paper has it: models/paper.yaml
};
constexpr auto EnumNames(Preset) { return EnumTable<Preset, 1>{{{Preset::kPaper, "paper"}}}; }

/// The preset's trained model, "paper.model", and its settings for fallen-train, "paper.yaml",
/// beside the shipped model.
std::filesystem::path PresetModelPath(Preset preset);
std::filesystem::path PresetTrainingPath(Preset preset);

/// Adds --preset. @param help  What it means to the tool.
void AddPresetOption(CLI::App& parser, std::optional<Preset>& preset, const std::string& help);

/// What the command line says about the detector.
struct DetectorOptions {
  std::optional<std::filesystem::path> config;  ///< nothing: all defaults
  std::string model;  ///< empty: the preset's, else the configuration's, else the shipped
  std::optional<Preset> preset;  ///< only in its model
  std::string environment_map;   ///< empty: the configuration's, else none
};

/// Adds --config, --model and --map.
void AddModelOptions(CLI::App& parser, DetectorOptions& options);

/// The same and --preset.
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
