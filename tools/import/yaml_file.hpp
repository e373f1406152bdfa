// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>

namespace fallen {

/// A YAML file, with errors that name file and line. Keys that nobody asks for are ignored.
class YamlFile {
 public:
  /// @throws InputError if the file cannot be read, is no YAML or no map.
  explicit YamlFile(const std::filesystem::path& file);

  const YAML::Node& root() const { return root_; }

  /// Value of `key` in `parent`. @throws InputError if there is none.
  YAML::Node Require(const YAML::Node& parent, const std::string& key) const;
  /// @throws InputError if it is missing or no finite number.
  double Number(const YAML::Node& parent, const std::string& key) const;
  /// @throws InputError if it is missing or no number > 0.
  double PositiveNumber(const YAML::Node& parent, const std::string& key) const;
  /// @throws InputError if it is missing or no whole number.
  int WholeNumber(const YAML::Node& parent, const std::string& key) const;
  bool Boolean(const YAML::Node& parent, const std::string& key) const;

  [[noreturn]] void Fail(const YAML::Node& node, const std::string& got,
                         const std::string& expected) const;

 private:
  std::filesystem::path file_;
  YAML::Node root_;
};

}  // namespace fallen
