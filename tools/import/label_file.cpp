// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/label_file.hpp"

#include <string>

#include "tools/import/yaml_file.hpp"

namespace fallen {
namespace {

Eigen::Vector3d ReadVector(const YamlFile& file, const YAML::Node& parent, const std::string& key) {
  const YAML::Node node = file.Require(parent, key);
  std::vector<double> values;
  if (!node.IsSequence() || !YAML::convert<std::vector<double>>::decode(node, values) ||
      values.size() != 3 || !Eigen::Vector3d(values.data()).allFinite())
    file.Fail(node, "a malformed " + key, "[x, y, z] in metres");
  return Eigen::Vector3d(values.data());
}

std::string ReadName(const YamlFile& file, const YAML::Node& parent, const std::string& key) {
  const YAML::Node node = parent[key];
  if (!node) return {};
  if (!node.IsScalar()) file.Fail(node, key + " that is no text", "a name");
  return node.Scalar();
}

GroundTruth ReadPerson(const YamlFile& file, const YAML::Node& parent, const std::string& room) {
  const YAML::Node person = file.Require(parent, "person");
  GroundTruth truth;
  truth.room = room;
  if (!file.Boolean(person, "present")) return truth;
  truth.person = ReadName(file, person, "name");
  const YAML::Node box = file.Require(person, "box");
  OrientedBox person_box;
  person_box.center = ReadVector(file, box, "center");
  person_box.size = ReadVector(file, box, "size");
  person_box.yaw = file.Number(box, "yaw");
  if (person_box.size.minCoeff() <= 0) file.Fail(box["size"], "an edge <= 0", "edges > 0");
  truth.person_box = person_box;
  return truth;
}

/// Two numbers, the first not larger than the second.
template <class Number>
std::optional<std::pair<Number, Number>> ReadRange(const YamlFile& file, const YAML::Node& parent,
                                                   const std::string& key) {
  const YAML::Node node = parent[key];
  if (!node) return std::nullopt;
  std::vector<Number> ends;
  if (!node.IsSequence() || !YAML::convert<std::vector<Number>>::decode(node, ends) ||
      ends.size() != 2 || !(ends[0] >= 0 && ends[0] <= ends[1]))
    file.Fail(node, "malformed " + key, "[first, last] from 0, in order");
  return std::pair(ends[0], ends[1]);
}

LabelledStretch ReadStretch(const YamlFile& file, const YAML::Node& node, const std::string& room) {
  if (!node.IsMap()) file.Fail(node, "a stretch that is no map", "frames or seconds, and person");
  LabelledStretch stretch;
  stretch.line = node.Mark().line + 1;
  stretch.frames = ReadRange<std::int64_t>(file, node, "frames");
  stretch.seconds = ReadRange<double>(file, node, "seconds");
  if (stretch.frames.has_value() == stretch.seconds.has_value())
    file.Fail(node, stretch.frames ? "frames and seconds" : "neither frames nor seconds",
              "one of frames: [first, last] and seconds: [from, to]");
  stretch.truth = ReadPerson(file, node, room);
  return stretch;
}

}  // namespace

bool LabelledStretch::Holds(std::int64_t frame, double seconds_since_first) const {
  if (frames) return frames->first <= frame && frame <= frames->second;
  if (seconds)
    return seconds->first <= seconds_since_first && seconds_since_first <= seconds->second;
  return true;
}

std::optional<GroundTruth> LabelFile::At(std::int64_t frame, double seconds_since_first) const {
  for (const LabelledStretch& stretch : stretches)
    if (stretch.Holds(frame, seconds_since_first)) return stretch.truth;
  return std::nullopt;
}

LabelFile ReadLabelFile(const std::filesystem::path& path) {
  const YamlFile file(path);
  const YAML::Node& root = file.root();
  const std::string room = ReadName(file, root, "room");
  LabelFile labels{path, {}};
  const YAML::Node list = root["stretches"];
  if (!list) {
    LabelledStretch whole;
    whole.line = root.Mark().line + 1;
    whole.truth = ReadPerson(file, root, room);
    labels.stretches.push_back(std::move(whole));
    return labels;
  }
  if (!list.IsSequence() || list.size() == 0)
    file.Fail(list, "stretches without a list", "a list of stretches");
  for (const YAML::Node& node : list) labels.stretches.push_back(ReadStretch(file, node, room));
  return labels;
}

}  // namespace fallen
