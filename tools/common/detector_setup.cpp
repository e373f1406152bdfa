// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/detector_setup.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "fallen/service/configuration.hpp"
#include "fallen/service/load_files.hpp"

namespace fallen {

std::filesystem::path PresetModelPath(Preset preset) {
  return ShippedModelPath().replace_filename(std::string(EnumName(preset)) + ".model");
}

std::filesystem::path PresetTrainingPath(Preset preset) {
  return ShippedModelPath().replace_filename(std::string(EnumName(preset)) + ".yaml");
}

void AddPresetOption(CLI::App& parser, std::optional<Preset>& preset, const std::string& help) {
  std::vector<std::string> names;
  for (const auto& [value, name] : EnumNames(Preset{})) names.emplace_back(name);
  parser
      .add_option_function<std::string>(
          "--preset", [&preset](const std::string& name) { preset = EnumFromName<Preset>(name); },
          help)
      ->check(CLI::IsMember(names));
}

void AddModelOptions(CLI::App& parser, DetectorOptions& options) {
  parser.add_option("--config", options.config, "Configuration (YAML); default: all defaults");
  parser.add_option("--model", options.model,
                    "Model; default: the configuration's, else the shipped");
  parser.add_option("--map", options.environment_map,
                    "Environment map; default: the configuration's, else everything is foreground");
}

void AddDetectorOptions(CLI::App& parser, DetectorOptions& options) {
  AddModelOptions(parser, options);
  AddPresetOption(parser, options.preset,
                  "Use the model of the method as the paper has it (paper)");
}

DetectorParts LoadDetectorParts(const DetectorOptions& options) {
  const Configuration file = LoadConfiguration(options.config);
  const std::string model = options.model.empty() && options.preset
                                ? PresetModelPath(*options.preset).string()
                                : options.model;
  DetectorParts parts{
      LoadModelFor(file, model), {}, LoadBackgroundFor(file, options.environment_map)};
  parts.config.ground = file.ground;
  parts.config.ndt = file.ndt;
  parts.config.background = file.background;
  parts.config.segmentation = file.SegmentationOver(parts.model.segmentation);
  parts.config.classification = file.classification;
  return parts;
}

Detector MakeDetector(const DetectorOptions& options) {
  DetectorParts parts = LoadDetectorParts(options);
  return Detector(std::move(parts.model), parts.config, std::move(parts.background));
}

}  // namespace fallen
