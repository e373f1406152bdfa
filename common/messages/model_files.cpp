// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/model_files.hpp"

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/message_file.hpp"

namespace fallen {
namespace {

constexpr ContainerKind kModelFile{"FALLENMD", "a model file", 4};
constexpr ContainerKind kEnvironmentMapFile{"FALLENEM", "an environment map file", 1};

}  // namespace

Model LoadModel(const std::filesystem::path& path) {
  return LoadMessageFile<model_t>(path, kModelFile);
}

EnvironmentMap LoadEnvironmentMap(const std::filesystem::path& path) {
  return LoadMessageFile<environment_map_t>(path, kEnvironmentMapFile);
}

void SaveModel(const std::filesystem::path& path, const Model& model) {
  WriteContainer(path, kModelFile, EncodeMessage(ToMessage(model)));
}

void SaveEnvironmentMap(const std::filesystem::path& path, const EnvironmentMap& map,
                        const std::string& description) {
  WriteContainer(path, kEnvironmentMapFile, EncodeMessage(ToMessage(map, description)));
}

}  // namespace fallen
