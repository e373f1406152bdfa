// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/configuration.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "fallen/service/channels.hpp"
#include "fallen/service/yaml_fields.hpp"

namespace fallen {
namespace {

constexpr char kSections[] =
    "ground ndt background segmentation classification alarm files service capture history mqtt";

/// Fills `config` from the section `name` and takes the name off the list of those to be explained.
template <class Config>
void TakeSection(const YAML::Node& root, const std::string& file, const char* name, Config& config,
                 std::vector<std::string>& known, YamlNull null_means = YamlNull::kError) {
  known.emplace_back(name);
  const YAML::Node section = root[name];
  if (section.IsDefined() && !section.IsNull())
    ReadYamlSection(section, {file, name}, config, null_means);
}

void RefuseUnknownSections(const YAML::Node& root, const std::string& file,
                           const std::vector<std::string>& known) {
  for (const auto& entry : root) {
    const std::string& name = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    ThrowAt(entry.first, {file, ""},
            name + ": unknown section, expected one of " + std::string(kSections));
  }
}

std::string RelativeTo(const std::filesystem::path& folder, const std::string& path) {
  return path.empty() ? path : (folder / path).lexically_normal().string();
}

}  // namespace

void ServiceConfig::Validate() const {
  if (lcm_url.empty()) throw std::invalid_argument("service: lcm_url is empty, must be an LCM URL");
  for (const auto& [key, name] : {std::pair{"camera", &camera},
                                  {"robot", &robot},
                                  {"pose_channel", &pose_channel},
                                  {"depth_channel", &depth_channel}})
    if (!channels::IsValidCamera(*name) && !(name == &depth_channel && name->empty()))
      throw std::invalid_argument(std::string("service: ") + key + " is '" + *name +
                                  "', must be 1 to " + std::to_string(channels::kMaxCameraLength) +
                                  " letters, digits, '_' or '-'");
}

SegmentationConfig Configuration::SegmentationOver(const SegmentationConfig& model_settings) const {
  SegmentationConfig settings = model_settings;
  if (override_segmentation) override_segmentation(settings);
  return settings;
}

Configuration LoadConfiguration(const std::optional<std::filesystem::path>& path) {
  Configuration config;
  if (!path) return config;
  config.source = path->string();
  const std::string& file = config.source;
  const YAML::Node root = LoadYamlMap(file);

  std::vector<std::string> known;
  TakeSection(root, file, "ground", config.ground, known);
  TakeSection(root, file, "ndt", config.ndt, known);
  TakeSection(root, file, "background", config.background, known);
  TakeSection(root, file, "classification", config.classification, known);
  TakeSection(root, file, "alarm", config.alarm, known);
  TakeSection(root, file, "files", config.files, known);
  TakeSection(root, file, "service", config.service, known);
  TakeSection(root, file, "capture", config.capture, known);
  TakeSection(root, file, "history", config.history, known);
  TakeSection(root, file, "mqtt", config.mqtt, known);
  // Over the defaults now, so that a mistake is found without a model; over the model's in use.
  SegmentationConfig trial;
  TakeSection(root, file, "segmentation", trial, known, YamlNull::kKeepValue);
  RefuseUnknownSections(root, file, known);

  const YAML::Node segmentation = root["segmentation"];
  if (segmentation.IsDefined() && !segmentation.IsNull())
    config.override_segmentation = [segmentation, file](SegmentationConfig& settings) {
      ReadYamlSection(segmentation, {file, "segmentation"}, settings, YamlNull::kKeepValue);
    };
  for (std::string* file_path :
       {&config.files.model, &config.files.environment_map, &config.files.zones,
        &config.history.file, &config.mqtt.ca_file, &config.mqtt.password_file})
    *file_path = RelativeTo(path->parent_path(), *file_path);
  return config;
}

}  // namespace fallen
