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

DetectorParts LoadDetectorParts(const DetectorOptions& options) {
  const Configuration file = LoadConfiguration(options.config);
  DetectorParts parts{
      LoadModelFor(file, options.model), {}, LoadBackgroundFor(file, options.environment_map)};
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
