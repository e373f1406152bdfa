// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "fallen/geometry/enum_names.hpp"

/// Fills configuration structs from YAML by their `Visit`, with errors that name file and line.
///
/// Includes yaml-cpp: meant for .cpp files.
namespace fallen {

/// Where a value stands: "<file>:<line>: <path>" in messages.
struct YamlPlace {
  std::string file;
  std::string path;  ///< "ground.method"

  YamlPlace Member(const std::string& key) const {
    return {file, path.empty() ? key : path + "." + key};
  }
};

/// What `key: null` means for a field that is no std::optional.
enum class YamlNull { kError, kKeepValue };

/// @throws std::runtime_error "<file>:<line>: <path>: got ..., expected ...".
[[noreturn]] void ThrowUnexpected(const YAML::Node& node, const YamlPlace& place,
                                  const std::string& expected);
/// @throws std::runtime_error "<file>:<line>: <text>".
[[noreturn]] void ThrowAt(const YAML::Node& node, const YamlPlace& place, const std::string& text);

/// Parses a file that holds one map; an empty file is an empty map.
/// @throws std::runtime_error naming the file, and the line of what is no YAML or occurs twice.
YAML::Node LoadYamlMap(const std::string& file);

/// Refuses anything but a map (or nothing), and keys that occur twice.
void RequireYamlMap(const YAML::Node& node, const YamlPlace& place);

void ReadYaml(const YAML::Node& node, const YamlPlace& place, bool& value);
void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::int32_t& value);
void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::int64_t& value);
/// Finite numbers only.
void ReadYaml(const YAML::Node& node, const YamlPlace& place, double& value);
void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::string& value);

template <class Enum>
requires std::is_enum_v<Enum>
void ReadYaml(const YAML::Node& node, const YamlPlace& place, Enum& value) {
  const std::optional<Enum> named =
      node.IsScalar() ? EnumFromName<Enum>(node.Scalar()) : std::nullopt;
  if (named) {
    value = *named;
    return;
  }
  std::string expected = "one of";
  for (const auto& [candidate, name] : EnumNames(Enum{})) expected += " " + std::string(name);
  ThrowUnexpected(node, place, expected);
}

template <class T, std::size_t N>
void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::array<T, N>& value) {
  if (!node.IsSequence() || node.size() != N)
    ThrowUnexpected(node, place, "a list of " + std::to_string(N) + " values");
  for (std::size_t i = 0; i < N; ++i) ReadYaml(node[i], place, value[i]);
}

template <class T>
void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::vector<T>& value) {
  if (!node.IsSequence()) ThrowUnexpected(node, place, "a list");
  value.clear();
  for (const YAML::Node& element : node) ReadYaml(element, place, value.emplace_back());
}

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// A struct with `Visit`: `node` must be a map whose keys it visits. Fields without a key stay.
/// @param null_means  For optionals null always means "unset".
template <class Config>
requires std::is_class_v<Config> && requires(Config c) {
  c.Visit([](const char*, auto&) {});
}
void ReadYaml(const YAML::Node& node, const YamlPlace& place, Config& config,
              YamlNull null_means = YamlNull::kError) {
  RequireYamlMap(node, place);
  std::vector<std::string> known;
  config.Visit([&](const char* key, auto& value) {
    known.emplace_back(key);
    const YAML::Node child = node[key];
    if (!child.IsDefined()) return;
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (IsOptional<Value>::value) {
      value.reset();
      if (!child.IsNull()) ReadYaml(child, place.Member(key), value.emplace());
    } else {
      if (child.IsNull() && null_means == YamlNull::kKeepValue) return;
      ReadYaml(child, place.Member(key), value);
    }
  });
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    bool is_known = false;
    for (const std::string& candidate : known) is_known = is_known || candidate == key;
    if (is_known) continue;
    std::string expected = "one of";
    for (const std::string& candidate : known) expected += " " + candidate;
    ThrowAt(entry.first, place, place.Member(key).path + ": unknown key, expected " + expected);
  }
}

/// Reports what a Validate() threw at the line of the key in `section` that `what` names.
[[noreturn]] void ThrowInvalid(const YAML::Node& section, const YamlPlace& place,
                               const std::string& what);

/// As ReadYaml, then `config.Validate()`: what that refuses is reported with the line of the key
/// that it names.
template <class Config>
void ReadYamlSection(const YAML::Node& node, const YamlPlace& place, Config& config,
                     YamlNull null_means = YamlNull::kError) {
  ReadYaml(node, place, config, null_means);
  if constexpr (requires { config.Validate(); }) {
    try {
      config.Validate();
    } catch (const std::invalid_argument& error) {
      ThrowInvalid(node, place, error.what());
    }
  }
}

}  // namespace fallen
