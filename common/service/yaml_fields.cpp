// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/yaml_fields.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace fallen {
namespace {

std::string At(const YAML::Node& node, const YamlPlace& place) {
  const YAML::Mark mark = node.IsDefined() ? node.Mark() : YAML::Mark::null_mark();
  if (mark.is_null()) return place.file + ": ";
  return place.file + ":" + std::to_string(mark.line + 1) + ": ";
}

std::string Described(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return "nothing";
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  return "'" + node.Scalar() + "'";
}

template <class T>
void ReadScalar(const YAML::Node& node, const YamlPlace& place, const char* expected, T& value) {
  if (!node.IsScalar() || !YAML::convert<T>::decode(node, value))
    ThrowUnexpected(node, place, expected);
}

}  // namespace

void ThrowAt(const YAML::Node& node, const YamlPlace& place, const std::string& text) {
  throw std::runtime_error(At(node, place) + text);
}

void ThrowUnexpected(const YAML::Node& node, const YamlPlace& place, const std::string& expected) {
  ThrowAt(node, place, place.path + ": got " + Described(node) + ", expected " + expected);
}

void RequireYamlMap(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsDefined() || node.IsNull()) return;
  if (!node.IsMap()) {
    const std::string what = place.path.empty() ? std::string("top level") : place.path;
    ThrowUnexpected(node, {place.file, what}, "a map of keys");
  }
  std::set<std::string> seen;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) ThrowAt(entry.first, place, "a key that is no plain word");
    const std::string& key = entry.first.Scalar();
    if (!seen.insert(key).second)
      ThrowAt(entry.first, place, place.Member(key).path + ": given twice, expected once");
  }
}

YAML::Node LoadYamlMap(const std::string& file) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(file);
  } catch (const YAML::BadFile&) {
    throw std::runtime_error(file + ": cannot be read, expected a YAML file");
  } catch (const YAML::ParserException& error) {
    throw std::runtime_error(file + ":" + std::to_string(error.mark.line + 1) +
                             ": no valid YAML: " + error.msg);
  }
  RequireYamlMap(root, {file, ""});
  return root;
}

void ReadYaml(const YAML::Node& node, const YamlPlace& place, bool& value) {
  ReadScalar(node, place, "true or false", value);
}

void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::int32_t& value) {
  ReadScalar(node, place, "a whole number", value);
}

void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::int64_t& value) {
  ReadScalar(node, place, "a whole number", value);
}

void ReadYaml(const YAML::Node& node, const YamlPlace& place, double& value) {
  ReadScalar(node, place, "a number", value);
  if (!std::isfinite(value)) ThrowUnexpected(node, place, "a finite number");
}

void ReadYaml(const YAML::Node& node, const YamlPlace& place, std::string& value) {
  ReadScalar(node, place, "text", value);
}

void ThrowInvalid(const YAML::Node& section, const YamlPlace& place, const std::string& what) {
  // The longest key that the message names: "min_range_m" must not be taken for "range_m".
  YAML::Node culprit = section;
  std::size_t longest = 0;
  for (const auto& entry : section) {
    const std::string& key = entry.first.Scalar();
    if (key.size() <= longest || what.find(key) == std::string::npos) continue;
    longest = key.size();
    culprit.reset(entry.first);
  }
  ThrowAt(culprit, place, what);
}

}  // namespace fallen
