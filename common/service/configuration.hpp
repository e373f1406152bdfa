// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fallen/detection/detector.hpp"

/// Configuration of a deployment: one YAML file that every service and tool reads its sections of.
///
/// Sections: ground, ndt, background, segmentation, classification, files (model, environment_map),
/// service (lcm_url, camera), capture. Every key has a default; an unknown key or section, a value of
/// a wrong type or out of range is an error that names file and line.
namespace fallen {

/// Files that stages load. Relative paths are relative to the configuration file.
struct FilesConfig {
  std::string model;            ///< empty: the shipped model
  std::string environment_map;  ///< empty: none, everything is foreground

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("model", model);
    visit("environment_map", environment_map);
  }
};

struct ServiceConfig {
  std::string lcm_url = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";
  std::string camera = "CAMERA";

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("lcm_url", lcm_url);
    visit("camera", camera);
  }
};

/// A loaded configuration. `segmentation` holds what the file overrides: apply it on the model's.
struct Configuration {
  GroundConfig ground;
  NdtConfig ndt;
  BackgroundConfig background;
  ClassificationConfig classification;
  FilesConfig files;
  ServiceConfig service;

  /// The model's segmentation settings with the file's overrides.
  SegmentationConfig SegmentationOver(const SegmentationConfig& model_settings) const;

  std::string segmentation_yaml;  ///< the section's text, "" if absent
  std::string source;             ///< file, "" for the defaults
};

/// @param path  Nothing: all defaults.
/// @throws std::runtime_error: "<file>:<line>: <section>.<key>: got ..., expected ...".
Configuration LoadConfiguration(const std::optional<std::filesystem::path>& path);

/// The shipped model: beside the executable's installation, or in the source tree of a build.
std::filesystem::path ShippedModelPath();

}  // namespace fallen
