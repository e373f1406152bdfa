// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <set>
#include <string>
#include <type_traits>

#include "fallen/service/config_text.hpp"
#include "fallen/service/configuration.hpp"
#include "fallen/service/yaml_fields.hpp"

namespace fallen {
namespace {

const std::filesystem::path kConfigFolder = FALLEN_SOURCE_DIR "/config";

/// Expects every field of `Config` in the section, with the struct's default, and nothing else.
template <class Config>
void ExpectDefaults(const YAML::Node& root, const char* name) {
  SCOPED_TRACE(name);
  const YAML::Node section = root[name];
  ASSERT_TRUE(section.IsMap());
  std::set<std::string> documented;
  for (const auto& entry : section) documented.insert(entry.first.Scalar());
  Config defaults;
  defaults.Visit([&](const char* key, auto& value) {
    SCOPED_TRACE(key);
    ASSERT_EQ(documented.erase(key), 1U) << "not in config/default.yaml";
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (IsOptional<Value>::value) {
      EXPECT_TRUE(section[key].IsNull());
      EXPECT_FALSE(value);
    } else {
      Value read = value;
      ReadYaml(section[key], {"default.yaml", key}, read);
      EXPECT_EQ(ConfigText(read), ConfigText(value));
    }
  });
  EXPECT_THAT(documented, testing::IsEmpty());
}

TEST(ShippedConfiguration, DefaultYamlListsEveryKeyWithItsDefault) {
  const YAML::Node root = LoadYamlMap((kConfigFolder / "default.yaml").string());
  ExpectDefaults<ServiceConfig>(root, "service");
  ExpectDefaults<CaptureConfig>(root, "capture");
  ExpectDefaults<FilesConfig>(root, "files");
  ExpectDefaults<GroundConfig>(root, "ground");
  ExpectDefaults<NdtConfig>(root, "ndt");
  ExpectDefaults<BackgroundConfig>(root, "background");
  ExpectDefaults<ClassificationConfig>(root, "classification");
  ExpectDefaults<AlarmConfig>(root, "alarm");
  ExpectDefaults<HistoryConfig>(root, "history");
  ExpectDefaults<MqttConfig>(root, "mqtt");
}

TEST(ShippedConfiguration, DefaultYamlListsEverySegmentationKeyAsTheModels) {
  const YAML::Node section = LoadYamlMap((kConfigFolder / "default.yaml").string())["segmentation"];
  std::size_t fields = 0;
  SegmentationConfig{}.Visit([&](const char* key, auto&) {
    ++fields;
    EXPECT_TRUE(section[key].IsDefined() && section[key].IsNull()) << key;
  });
  EXPECT_EQ(section.size(), fields);
}

TEST(ShippedConfiguration, EveryFileLoads) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfigFolder)) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    EXPECT_NO_THROW(LoadConfiguration(entry.path())) << entry.path();
  }
  EXPECT_GE(files, 3);
}

TEST(ShippedConfiguration, DefaultYamlChangesNothing) {
  const Configuration config = LoadConfiguration(kConfigFolder / "default.yaml");
  EXPECT_EQ(ConfigText(config.ndt), ConfigText(NdtConfig{}));
  EXPECT_EQ(config.files.model, "");
  SegmentationConfig model;
  model.min_score = 0.125;
  EXPECT_EQ(config.SegmentationOver(model), model);
}

TEST(ShippedConfiguration, TextOfAConfigurationReadsBackAsTheSame) {
  NdtConfig config;
  config.cell_size_m = 0.1 + 0.2;  // has no short decimal form
  config.without_pose = PoseMode::kFixedCamera;
  NdtConfig read;
  ReadYaml(YAML::Load(ConfigText(config)), {"text", "ndt"}, read);
  EXPECT_EQ(ConfigText(read), ConfigText(config));
  EXPECT_EQ(read.cell_size_m, config.cell_size_m);
}

}  // namespace
}  // namespace fallen
