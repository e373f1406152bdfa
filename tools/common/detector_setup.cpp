// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/detector_setup.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <utility>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/configuration.hpp"

namespace fallen {
namespace {

/// The first of: what the command line says, what the configuration says, nothing.
std::filesystem::path Choose(const std::optional<std::filesystem::path>& option,
                             const std::string& configured) {
  return option ? *option : std::filesystem::path(configured);
}

BackgroundSubtractor MakeBackground(const std::filesystem::path& map,
                                    const BackgroundConfig& config) {
  if (map.empty()) return BackgroundSubtractor(config);
  return BackgroundSubtractor(LoadEnvironmentMap(map), config);
}

}  // namespace

void AddDetectorOptions(CLI::App& parser, DetectorOptions& options) {
  parser.add_option("--config", options.config, "Configuration (YAML); default: all defaults");
  parser.add_option("--model", options.model,
                    "Model; default: the configuration's, else the shipped");
  parser.add_option("--map", options.environment_map,
                    "Environment map; default: the configuration's, else everything is foreground");
}

Detector MakeDetector(const DetectorOptions& options) {
  const Configuration file = LoadConfiguration(options.config);
  std::filesystem::path model_path = Choose(options.model, file.files.model);
  if (model_path.empty()) model_path = ShippedModelPath();
  Model model = LoadModel(model_path);

  DetectorConfig config;
  config.ground = file.ground;
  config.ndt = file.ndt;
  config.background = file.background;
  config.segmentation = file.SegmentationOver(model.segmentation);
  config.classification = file.classification;
  const std::filesystem::path map = Choose(options.environment_map, file.files.environment_map);
  try {
    return Detector(std::move(model), config, MakeBackground(map, file.background));
  } catch (const std::invalid_argument& error) {
    const std::string with_map = map.empty() ? "" : " with " + map.string();
    throw std::runtime_error(model_path.string() + with_map + ": " + error.what());
  }
}

}  // namespace fallen
