// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/model_files.hpp"

#include <stdexcept>

#include "fallen/messages/container_file.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"

namespace fallen {
namespace {

constexpr ContainerKind kModelFile{"FALLENMD", "a model file", 2};
constexpr ContainerKind kEnvironmentMapFile{"FALLENEM", "an environment map file", 1};

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

template <class Message>
auto Load(const std::filesystem::path& path, const ContainerKind& kind) {
  const std::vector<std::uint8_t> bytes = ReadContainer(path, kind);
  const Decoded<Message> decoded = DecodeMessage<Message>(bytes);
  if (!decoded) Fail(path, decoded.error);
  try {
    return FromMessage(*decoded.message);
  } catch (const std::invalid_argument& error) {
    Fail(path, error.what());
  }
}

}  // namespace

Model LoadModel(const std::filesystem::path& path) { return Load<model_t>(path, kModelFile); }

EnvironmentMap LoadEnvironmentMap(const std::filesystem::path& path) {
  return Load<environment_map_t>(path, kEnvironmentMapFile);
}

void SaveModel(const std::filesystem::path& path, const Model& model) {
  WriteContainer(path, kModelFile, EncodeMessage(ToMessage(model)));
}

void SaveEnvironmentMap(const std::filesystem::path& path, const EnvironmentMap& map,
                        const std::string& description) {
  WriteContainer(path, kEnvironmentMapFile, EncodeMessage(ToMessage(map, description)));
}

}  // namespace fallen
