// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/furniture_catalogue.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "tools/simulate/random.hpp"

namespace fallen::sim {
namespace {

using std::filesystem::path;

constexpr const char* kArchives[] = {"BlendSwap-CC-0", "BlendSwap-CC-BY", "KatorLegaz"};
constexpr double kMetresPerCentimetre = 0.01;

double Number(const path& file, const std::string& key, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error(file.string() + ": " + key + ": got '" + text +
                             "', expected a number");
  return value;
}

// Entries by number: lines look like "width#12=59.4".
std::map<int, std::map<std::string, std::string>> ReadEntries(const path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(file.string() +
                             ": got no such file, expected it from tools/fetch-assets");
  std::map<int, std::map<std::string, std::string>> entries;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t hash = line.find('#'), equals = line.find('=');
    if (hash == std::string::npos || equals == std::string::npos || hash == 0 || hash > equals)
      continue;
    int number = 0;
    const auto [end, error] = std::from_chars(line.data() + hash + 1, line.data() + equals, number);
    if (error == std::errc() && end == line.data() + equals)
      entries[number][line.substr(0, hash)] = line.substr(equals + 1);
  }
  return entries;
}

double LuminanceOf(const aiMaterial& material) {
  aiColor3D color(0.6f, 0.6f, 0.6f);
  material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  return 0.3 * color.r + 0.59 * color.g + 0.11 * color.b;
}

// Near infrared: dark dyes and lacquers reflect more of it than the eye would think.
double AlbedoOf(const aiMaterial& material) {
  if (material.GetTextureCount(aiTextureType_DIFFUSE) > 0) return kUsualAlbedo;
  return 0.15 + 0.75 * std::clamp(LuminanceOf(material), 0.0, 1.0);
}

bool IsPane(const aiMaterial& material) {
  float opacity = 1;
  material.Get(AI_MATKEY_OPACITY, opacity);
  return opacity < 0.5f;
}

}  // namespace

FurniturePool PoolOf(const std::string& model_name) {
  // There are few beds, and chance has put none of them into the test pool.
  static const std::map<std::string, FurniturePool> moved = {
      {"BlendSwap-CC-0/bed1", FurniturePool::kTest},
      {"BlendSwap-CC-BY/juniorBed", FurniturePool::kTest}};
  if (const auto found = moved.find(model_name); found != moved.end()) return found->second;
  const auto share = MixBits(StableHash(model_name)) % 100;
  if (share < 60) return FurniturePool::kTrain;
  return share < 80 ? FurniturePool::kValidation : FurniturePool::kTest;
}

std::vector<const FurnitureModel*> FurnitureCatalogue::Select(FurnitureRole role,
                                                              FurniturePool pool) const {
  std::vector<const FurnitureModel*> selected;
  const bool any_pool =
      pool == FurniturePool::kAll || role == FurnitureRole::kDog || role == FurnitureRole::kCat;
  for (const FurnitureModel& model : models)
    if (model.role == role && (any_pool || PoolOf(model.name) == pool)) selected.push_back(&model);
  return selected;
}

FurnitureCatalogue LoadFurnitureCatalogue(const path& assets) {
  FurnitureCatalogue catalogue;
  for (const char* archive : kArchives) {
    const path folder = assets / "furniture" / archive;
    const path file = folder / "PluginFurnitureCatalog.properties";
    for (auto& [number, entry] : ReadEntries(file)) {
      FurnitureModel model;
      const std::string& location = entry["model"];
      model.name = std::string(archive) + "/" + path(location).stem().string();
      const auto role = RoleOf(model.name);
      if (!role) continue;
      model.role = *role;
      model.file = folder / path(location).relative_path();
      const char* keys[] = {"width", "depth", "height"};
      for (int axis = 0; axis < 3; ++axis)
        model.size[axis] =
            Number(file, keys[axis] + ("#" + std::to_string(number)), entry[keys[axis]]) *
            kMetresPerCentimetre;
      if (entry.contains("modelRotation")) {
        std::istringstream stream(entry["modelRotation"]);
        for (int i = 0; i < 9; ++i) stream >> model.rotation(i / 3, i % 3);
      }
      catalogue.models.push_back(model);
    }
  }
  std::sort(catalogue.models.begin(), catalogue.models.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return catalogue;
}

TriangleMesh LoadFurnitureMesh(const FurnitureModel& model) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(model.file.string(), aiProcess_Triangulate |
                                                                    aiProcess_PreTransformVertices |
                                                                    aiProcess_SortByPType);
  if (scene == nullptr)
    throw std::runtime_error(model.file.string() + ": got '" + importer.GetErrorString() +
                             "', expected an OBJ model");
  TriangleMesh mesh;
  Eigen::AlignedBox3f bounds;  // panes count for the size
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& part = *scene->mMeshes[m];
    const aiMaterial& material = *scene->mMaterials[part.mMaterialIndex];
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D& p = part.mVertices[v];
      mesh.vertices.push_back(model.rotation.cast<float>() * Eigen::Vector3f(p.x, p.y, p.z));
      bounds.extend(mesh.vertices.back());
    }
    if (IsPane(material)) continue;
    const auto albedo = static_cast<std::uint8_t>(std::lround(255 * AlbedoOf(material)));
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;
      mesh.triangles.push_back(
          {face.mIndices[0] + offset, face.mIndices[1] + offset, face.mIndices[2] + offset});
      mesh.albedo.push_back(albedo);
    }
  }
  if (mesh.empty())
    throw std::runtime_error(model.file.string() + ": got no triangles, expected an OBJ model");
  // The file's frame has y up and z towards the front; the catalogue's size is what counts.
  const Eigen::Vector3f size = bounds.sizes().cwiseMax(1e-6f);
  const Eigen::Vector3f scale(static_cast<float>(model.size.x()) / size.x(),
                              static_cast<float>(model.size.z()) / size.y(),
                              static_cast<float>(model.size.y()) / size.z());
  const Eigen::Vector3f middle = bounds.center();
  for (Eigen::Vector3f& p : mesh.vertices)
    p = {(p.x() - middle.x()) * scale.x(), -(p.z() - middle.z()) * scale.z(),
         (p.y() - bounds.min().y()) * scale.y()};
  return mesh;
}

}  // namespace fallen::sim
