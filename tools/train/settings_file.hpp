// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "fallen/service/yaml_fields.hpp"

namespace fallen {

/// Settings from a YAML file, by their `Visit`; no file: the defaults. Meant for .cpp files.
/// @throws std::runtime_error naming file, line, got and expected.
template <class Settings>
Settings LoadSettings(const std::optional<std::filesystem::path>& path) {
  Settings settings;
  if (!path) return settings;
  const YAML::Node node = LoadYamlMap(path->string());
  ReadYamlSection(node, YamlPlace{path->string(), ""}, settings);
  return settings;
}

}  // namespace fallen
