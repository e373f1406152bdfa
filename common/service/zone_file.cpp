// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/zone_file.hpp"

#include <set>
#include <stdexcept>
#include <string>

#include "fallen/service/yaml_fields.hpp"

namespace fallen {
namespace {

/// A zone as it stands in the file.
struct ZoneEntry {
  std::string name;
  ZoneKind kind = ZoneKind::kNever;
  std::vector<std::array<double, 2>> corners;
  double bed_height_m = Zone{}.bed_height_m;

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("name", name);
    visit("kind", kind);
    visit("corners", corners);
    visit("bed_height_m", bed_height_m);
  }
};

Zone ReadZone(const YAML::Node& node, const YamlPlace& place) {
  ZoneEntry entry;
  if (!node.IsMap()) ThrowUnexpected(node, place, "a map of name, kind and corners");
  ReadYaml(node, place, entry);
  for (const char* key : {"name", "kind", "corners"})
    if (!node[key].IsDefined())
      ThrowAt(node, place, place.path + ": got no " + key + ", expected one");
  Zone zone{entry.name, entry.kind, {}, entry.bed_height_m};
  for (const auto& [x, y] : entry.corners) zone.corners.emplace_back(x, y);
  try {
    zone.Validate();
  } catch (const std::invalid_argument& error) {
    ThrowAt(node, place, error.what());
  }
  return zone;
}

}  // namespace

std::vector<Zone> LoadZones(const std::filesystem::path& path) {
  const YAML::Node root = LoadYamlMap(path.string());
  for (const auto& entry : root)
    if (entry.first.Scalar() != "zones")
      ThrowAt(entry.first, {path.string(), ""},
              entry.first.Scalar() + ": unknown key, expected zones");
  const YAML::Node list = root["zones"];
  const YamlPlace place{path.string(), "zones"};
  if (!list.IsDefined() || !list.IsSequence()) ThrowUnexpected(list, place, "a list of zones");
  std::vector<Zone> zones;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const YamlPlace here{place.file, "zones[" + std::to_string(i) + "]"};
    zones.push_back(ReadZone(list[i], here));
    if (!names.insert(zones.back().name).second)
      ThrowAt(list[i], here,
              here.path + ".name: got '" + zones.back().name + "' twice, expected it once");
  }
  return zones;
}

}  // namespace fallen
