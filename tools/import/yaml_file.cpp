// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/yaml_file.hpp"

#include <cmath>

#include "tools/import/input_error.hpp"

namespace fallen {
namespace {

std::string Got(const std::string& key, const YAML::Node& node) {
  if (node.IsScalar()) return key + " \"" + node.Scalar() + "\"";
  if (node.IsSequence()) return key + " with a list";
  if (node.IsMap()) return key + " with a map";
  return key + " without a value";
}

}  // namespace

YamlFile::YamlFile(const std::filesystem::path& file) : file_(file) {
  try {
    root_ = YAML::LoadFile(file.string());
  } catch (const YAML::BadFile&) {
    throw InputError(file, 0, "no readable file", "YAML");
  } catch (const YAML::ParserException& error) {
    throw InputError(file, error.mark.line + 1, "no YAML (" + error.msg + ")", "YAML");
  }
  if (!root_.IsMap()) throw InputError(file, 0, "no map", "lines of \"key: value\"");
}

void YamlFile::Fail(const YAML::Node& node, const std::string& got,
                    const std::string& expected) const {
  throw InputError(file_, node.Mark().line + 1, got, expected);
}

YAML::Node YamlFile::Require(const YAML::Node& parent, const std::string& key) const {
  const YAML::Node node = parent.IsMap() ? parent[key] : YAML::Node();
  if (!parent.IsMap() || !node) Fail(parent, "no " + key, "the key " + key);
  return node;
}

double YamlFile::Number(const YAML::Node& parent, const std::string& key) const {
  const YAML::Node node = Require(parent, key);
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
    Fail(node, Got(key, node), "a finite number");
  return value;
}

double YamlFile::PositiveNumber(const YAML::Node& parent, const std::string& key) const {
  const double value = Number(parent, key);
  if (value <= 0) Fail(parent[key], Got(key, parent[key]), "a number > 0");
  return value;
}

int YamlFile::WholeNumber(const YAML::Node& parent, const std::string& key) const {
  const YAML::Node node = Require(parent, key);
  int value = 0;
  if (!node.IsScalar() || !YAML::convert<int>::decode(node, value))
    Fail(node, Got(key, node), "a whole number");
  return value;
}

bool YamlFile::Boolean(const YAML::Node& parent, const std::string& key) const {
  const YAML::Node node = Require(parent, key);
  bool value = false;
  if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value))
    Fail(node, Got(key, node), "true or false");
  return value;
}

}  // namespace fallen
