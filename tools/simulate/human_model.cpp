// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/human_model.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fallen::sim {
namespace {

using Json = nlohmann::json;
using std::filesystem::path;

constexpr float kMetresPerUnit = 0.1f;           // MakeHuman's unit is the decimetre
constexpr float kMetresPerTargetStep = 0.0001f;  // targets.bin counts in 1/1000 of that
constexpr char kHeadSuffix[] = "____head";

Json ReadJson(const path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(file.string() +
                             ": got no such file, expected it from tools/fetch-assets");
  try {
    return Json::parse(stream);
  } catch (const Json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

HumanSurface SurfaceOf(const std::string& material) {
  if (material == "body") return HumanSurface::kBody;
  if (material == "helper-skirt") return HumanSurface::kSkirt;
  if (material == "helper-hair") return HumanSurface::kHair;
  return HumanSurface::kOther;
}

// Faces in three.js' format 3.1. This file holds one kind only: quads with a material and texture
// coordinates, i.e. [11, a, b, c, d, material, uv, uv, uv, uv].
std::vector<HumanQuad> ReadQuads(const Json& model) {
  constexpr int kQuadWithMaterialAndUv = 11;
  constexpr std::size_t kStride = 10, kMaterialOffset = 5;
  const auto faces = model.at("faces").get<std::vector<std::uint32_t>>();
  std::vector<HumanSurface> surfaces;
  for (const Json& material : model.at("materials"))
    surfaces.push_back(SurfaceOf(material.at("DbgName").get<std::string>()));
  std::vector<HumanQuad> quads;
  for (std::size_t i = 0; i + kStride <= faces.size(); i += kStride) {
    if (faces[i] != kQuadWithMaterialAndUv)
      throw std::runtime_error("faces[" + std::to_string(i) + "]: got " + std::to_string(faces[i]) +
                               ", expected 11");
    quads.push_back({{faces[i + 1], faces[i + 2], faces[i + 3], faces[i + 4]},
                     surfaces.at(faces[i + kMaterialOffset])});
  }
  return quads;
}

std::vector<Bone> ReadBones(const Json& rig) {
  std::vector<Bone> bones;
  std::map<std::string, int> placed;
  const Json& all = rig.at("bones");
  const Json& joints = rig.at("joints");
  // Several passes, until every bone stands behind its parent.
  while (bones.size() < all.size()) {
    const std::size_t before = bones.size();
    for (const auto& [name, bone] : all.items()) {
      if (placed.contains(name)) continue;
      const Json& parent = bone.at("parent");
      if (!parent.is_null() && !placed.contains(parent.get<std::string>())) continue;
      placed[name] = static_cast<int>(bones.size());
      bones.push_back({name, parent.is_null() ? -1 : placed[parent.get<std::string>()],
                       joints.at(bone.at("head").get<std::string>()).get<std::vector<int>>(),
                       joints.at(bone.at("tail").get<std::string>()).get<std::vector<int>>()});
    }
    if (bones.size() == before) throw std::runtime_error("bones: got a circle of parents");
  }
  return bones;
}

void ReadSkin(const Json& mesh, HumanModel& model) {
  std::vector<int> bone_of_index;
  for (const Json& entry : mesh.at("bones")) {
    std::string name = entry.at("name").get<std::string>();
    const std::size_t suffix = name.find(kHeadSuffix);
    if (suffix != std::string::npos) name.resize(suffix);
    bone_of_index.push_back(model.bone(name));
  }
  const auto indices = mesh.at("skinIndices").get<std::vector<int>>();
  const auto weights = mesh.at("skinWeights").get<std::vector<float>>();
  const auto count = static_cast<std::size_t>(model.base_vertices.cols());
  if (indices.size() != count * kInfluencesPerVertex || weights.size() != indices.size())
    throw std::runtime_error("skinWeights: got " + std::to_string(weights.size()) + ", expected " +
                             std::to_string(count * kInfluencesPerVertex));
  model.skin_bones.resize(count);
  model.skin_weights.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    float sum = 0;
    for (std::size_t k = 0; k < kInfluencesPerVertex; ++k) {
      model.skin_bones[v][k] =
          bone_of_index.at(static_cast<std::size_t>(indices[v * kInfluencesPerVertex + k]));
      model.skin_weights[v][k] = weights[v * kInfluencesPerVertex + k];
      sum += model.skin_weights[v][k];
    }
    // Helper vertices without weights go with the root.
    if (sum <= 0) model.skin_weights[v][0] = sum = 1;
    for (float& weight : model.skin_weights[v]) weight /= sum;
  }
}

}  // namespace

int HumanModel::bone(const std::string& name) const {
  const auto found = bone_index.find(name);
  if (found == bone_index.end())
    throw std::runtime_error("skeleton: got no bone '" + name +
                             "', expected MakeHuman's default rig");
  return found->second;
}

Eigen::Matrix3Xf HumanModel::MorphOffsets(
    const std::map<std::string, double>& target_weights) const {
  std::ifstream stream(targets_file, std::ios::binary);
  if (!stream) throw std::runtime_error(targets_file.string() + ": got no such file, expected it");
  const Eigen::Index values = base_vertices.size();
  std::vector<std::int16_t> steps(static_cast<std::size_t>(values));
  Eigen::Matrix3Xf offsets = Eigen::Matrix3Xf::Zero(3, base_vertices.cols());
  for (const auto& [name, weight] : target_weights) {
    const auto row = target_row.find(name);
    if (row == target_row.end())
      throw std::runtime_error(targets_file.string() + ": got no target '" + name +
                               "', expected it");
    if (weight == 0) continue;
    const auto bytes = static_cast<std::streamsize>(steps.size() * sizeof(std::int16_t));
    stream.seekg(bytes * row->second);
    if (!stream.read(reinterpret_cast<char*>(steps.data()), bytes))
      throw std::runtime_error(targets_file.string() + ": got its end in target '" + name +
                               "', expected " + std::to_string(bytes) + " bytes");
    const auto scale = static_cast<float>(weight) * kMetresPerTargetStep;
    for (Eigen::Index i = 0; i < values; ++i)
      offsets.data()[i] += scale * steps[static_cast<std::size_t>(i)];
  }
  return offsets;
}

HumanModel LoadHumanModel(const path& assets) {
  const path folder = assets / "makehuman";
  HumanModel model;
  const path mesh_file = folder / "human_full_size.json";
  const Json mesh = ReadJson(mesh_file);
  const Json rig = ReadJson(folder / "default.json");
  const Json targets = ReadJson(folder / "target-list.json");
  try {
    const auto coordinates = mesh.at("vertices").get<std::vector<float>>();
    model.base_vertices =
        Eigen::Map<const Eigen::Matrix3Xf>(coordinates.data(), 3,
                                           static_cast<Eigen::Index>(coordinates.size() / 3)) *
        kMetresPerUnit;
    model.quads = ReadQuads(mesh);
    model.bones = ReadBones(rig);
    for (std::size_t i = 0; i < model.bones.size(); ++i)
      model.bone_index[model.bones[i].name] = static_cast<int>(i);
    ReadSkin(mesh, model);
    // Rows of targets.bin are in the sorted order of these names; JSON objects here are sorted.
    int row = 0;
    const std::string prefix = "data/targets/", suffix = ".target";
    for (const auto& [name, parts] : targets.at("targets").items()) {
      const std::string key =
          name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
      model.target_row[key] = row++;
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error(mesh_file.string() + ": " + error.what());
  }
  model.targets_file = folder / "targets.bin";
  return model;
}

}  // namespace fallen::sim
