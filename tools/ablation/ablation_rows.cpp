// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/ablation_rows.hpp"

#include <set>

#include "fallen/service/config_text.hpp"
#include "fallen/service/yaml_fields.hpp"

namespace fallen {
namespace {

AblationRow ReadRow(const YAML::Node& node, const YamlPlace& place, const TrainingConfig& common) {
  AblationRow row;
  row.training = common;
  ReadYaml(node, place, row);
  if (row.oriented_normals) row.training.signs = NormalSigns::kOriented;
  row.retrains = node["training"].IsDefined() || row.oriented_normals;
  row.segmentation = row.training.segmentation;
  if (node["segmentation"].IsDefined())
    ReadYamlSection(node["segmentation"], place.Member("segmentation"), row.segmentation);
  if (row.name.empty()) ThrowAt(node, place, "name: got none, expected what the row shows");
  if (ConfigText(row.training.observation) != ConfigText(common.observation))
    ThrowAt(node, place, "training.observation: got other settings, expected those of all rows");
  try {
    row.training.Validate();
  } catch (const std::invalid_argument& error) {
    ThrowInvalid(node["training"], place, error.what());
  }
  return row;
}

}  // namespace

std::string AblationRow::Settings() const {
  return "training " + (retrains ? ConfigText(training) : "of the first row") + " segmentation " +
         ConfigText(segmentation) + " map " + ConfigText(map) + " accumulate " +
         ConfigText(accumulate) + " oriented normals " + ConfigText(oriented_normals);
}

std::vector<AblationRow> LoadAblationRows(const std::filesystem::path& file,
                                          const TrainingConfig& base) {
  const YAML::Node root = LoadYamlMap(file.string());
  const YamlPlace place{file.string(), ""};
  for (const auto& entry : root)
    if (entry.first.Scalar() != "training" && entry.first.Scalar() != "rows")
      ThrowAt(entry.first, place,
              entry.first.Scalar() + ": unknown key, expected one of training rows");
  TrainingConfig common = base;
  if (root["training"].IsDefined())
    ReadYamlSection(root["training"], place.Member("training"), common);
  const YAML::Node list = root["rows"];
  if (!list.IsDefined() || !list.IsSequence() || list.size() == 0)
    ThrowAt(root, place, "rows: got none, expected a list");

  std::vector<AblationRow> rows;
  std::set<std::string> names;
  for (const YAML::Node& node : list) {
    rows.push_back(ReadRow(node, place.Member("rows"), common));
    if (!names.insert(rows.back().name).second)
      ThrowAt(node, place, "rows: got two named " + rows.back().name + ", expected other names");
  }
  if (rows.front().oriented_normals)
    ThrowAt(list[0], place, "rows: got oriented_normals in the first, expected a model to keep");
  rows.front().retrains = true;
  return rows;
}

}  // namespace fallen
