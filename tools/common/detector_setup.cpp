// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/detector_setup.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "fallen/service/configuration.hpp"
#include "fallen/service/load_files.hpp"

namespace fallen {

void AddDetectorOptions(CLI::App& parser, DetectorOptions& options) {
  parser.add_option("--config", options.config, "Configuration (YAML); default: all defaults");
  parser.add_option("--model", options.model,
                    "Model; default: the configuration's, else the shipped");
  parser.add_option("--map", options.environment_map,
                    "Environment map; default: the configuration's, else everything is foreground");
}

Detector MakeDetector(const DetectorOptions& options) {
  const Configuration file = LoadConfiguration(options.config);
  Model model = LoadModelFor(file, options.model);
  DetectorConfig config;
  config.ground = file.ground;
  config.ndt = file.ndt;
  config.background = file.background;
  config.segmentation = file.SegmentationOver(model.segmentation);
  config.classification = file.classification;
  return Detector(std::move(model), config, LoadBackgroundFor(file, options.environment_map));
}

}  // namespace fallen
