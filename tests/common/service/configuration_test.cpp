// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/configuration.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

using testing::HasSubstr;

class ConfigurationFile : public testing::Test {
 protected:
  ConfigurationFile() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("fallen_configuration_") + test->name());
    std::filesystem::create_directories(folder_);
    file_ = folder_ / "test.yaml";
  }
  ~ConfigurationFile() override { std::filesystem::remove_all(folder_); }

  Configuration Load(const std::string& text) {
    std::ofstream(file_) << text;
    return LoadConfiguration(file_);
  }
  /// What loading `text` complains about, without the folder.
  std::string Complaint(const std::string& text) {
    try {
      Load(text);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      const std::size_t at = what.find("test.yaml");
      return at == std::string::npos ? what : what.substr(at);
    }
    return "none";
  }

  std::filesystem::path folder_;
  std::filesystem::path file_;
};

TEST_F(ConfigurationFile, ReadsEveryKindOfValue) {
  const Configuration config = Load(
      "ground:\n  method: ransac\n  max_tilt_deg: 20\n  ransac_seed: 12345678901\n"
      "ndt: {accumulate: false, min_points: 7, without_pose: fixed_camera}\n"
      "service: {camera: FRONT}\n"
      "capture:\n  mounting_position_m: [0.1, 0, 0.95]\n  mounting_roll_pitch_yaw_deg: [0, 20, "
      "0]\n");
  EXPECT_EQ(config.ground.method, GroundMethod::kRansac);
  EXPECT_EQ(config.ground.max_tilt_deg, 20);
  EXPECT_EQ(config.ground.ransac_seed, 12345678901);
  EXPECT_FALSE(config.ndt.accumulate);
  EXPECT_EQ(config.ndt.min_points, 7);
  EXPECT_EQ(config.ndt.without_pose, PoseMode::kFixedCamera);
  EXPECT_EQ(config.service.camera, "FRONT");
  ASSERT_TRUE(config.capture.mounting_position_m);
  EXPECT_EQ((*config.capture.mounting_position_m)[2], 0.95);
  EXPECT_EQ(config.ndt.cell_size_m, NdtConfig{}.cell_size_m) << "keys not given keep their default";
}

TEST_F(ConfigurationFile, EmptyFileAndEmptySectionsAreTheDefaults) {
  EXPECT_EQ(Load("").service.camera, ServiceConfig{}.camera);
  EXPECT_EQ(Load("ground:\nndt:\n").ndt.min_points, NdtConfig{}.min_points);
}

TEST_F(ConfigurationFile, UnknownKeyNamesLineAndWhatIsKnown) {
  const std::string complaint = Complaint("ndt:\n  min_points: 5\n  cell_sise_m: 0.05\n");
  EXPECT_THAT(complaint, testing::StartsWith("test.yaml:3: ndt.cell_sise_m: unknown key"));
  EXPECT_THAT(complaint, HasSubstr("cell_size_m"));
}

TEST_F(ConfigurationFile, UnknownSectionNamesLine) {
  EXPECT_THAT(Complaint("ndt:\n  min_points: 5\nndtt:\n  min_points: 5\n"),
              testing::StartsWith("test.yaml:3: ndtt: unknown section"));
}

TEST_F(ConfigurationFile, UnknownKeyInSegmentationIsFoundWithoutAModel) {
  EXPECT_THAT(Complaint("segmentation:\n  min_skore: 0\n"),
              testing::StartsWith("test.yaml:2: segmentation.min_skore: unknown key"));
}

TEST_F(ConfigurationFile, WrongTypesNameLineGotAndExpected) {
  EXPECT_EQ(Complaint("ndt:\n  min_points: many\n"),
            "test.yaml:2: ndt.min_points: got 'many', expected a whole number");
  EXPECT_EQ(Complaint("ndt:\n  min_points: 4.5\n"),
            "test.yaml:2: ndt.min_points: got '4.5', expected a whole number");
  EXPECT_EQ(Complaint("ndt:\n  min_points: 99999999999\n"),
            "test.yaml:2: ndt.min_points: got '99999999999', expected a whole number");
  EXPECT_EQ(Complaint("ndt:\n  accumulate: maybe\n"),
            "test.yaml:2: ndt.accumulate: got 'maybe', expected true or false");
  EXPECT_EQ(Complaint("ndt:\n  cell_size_m: .nan\n"),
            "test.yaml:2: ndt.cell_size_m: got '.nan', expected a finite number");
  EXPECT_EQ(Complaint("ndt:\n  cell_size_m: [1, 2]\n"),
            "test.yaml:2: ndt.cell_size_m: got a list of 2, expected a number");
  EXPECT_EQ(Complaint("ndt:\n  cell_size_m: null\n"),
            "test.yaml:2: ndt.cell_size_m: got nothing, expected a number");
  EXPECT_EQ(Complaint("ground:\n\n  method: guess\n"),
            "test.yaml:3: ground.method: got 'guess', expected one of auto mounting ransac "
            "v_disparity");
  EXPECT_EQ(
      Complaint("capture:\n  mounting_position_m: [0, 1]\n"),
      "test.yaml:2: capture.mounting_position_m: got a list of 2, expected a list of 3 values");
  EXPECT_EQ(Complaint("ndt: 5\n"), "test.yaml:1: ndt: got '5', expected a map of keys");
  EXPECT_EQ(Complaint("- 5\n"), "test.yaml:1: top level: got a list of 1, expected a map of keys");
}

TEST_F(ConfigurationFile, ValueOutOfRangeNamesTheKeysLine) {
  EXPECT_THAT(Complaint("ndt:\n  min_points: 5\n  max_range_m: 4\n  cell_size_m: -1\n"),
              testing::AllOf(testing::StartsWith("test.yaml:4: "), HasSubstr("cell_size_m")));
  EXPECT_THAT(Complaint("service:\n  camera: \"A B\"\n"),
              testing::AllOf(testing::StartsWith("test.yaml:2: "), HasSubstr("'A B'")));
  EXPECT_THAT(Complaint("capture:\n  mounting_position_m: [0, 0, 1]\n"),
              testing::StartsWith("test.yaml:2: "));
}

TEST_F(ConfigurationFile, KeyGivenTwiceIsRefused) {
  EXPECT_EQ(Complaint("ndt:\n  min_points: 5\n  min_points: 6\n"),
            "test.yaml:3: ndt.min_points: given twice, expected once");
  EXPECT_EQ(Complaint("ndt:\n  min_points: 5\nndt:\n  min_points: 6\n"),
            "test.yaml:3: ndt: given twice, expected once");
}

TEST_F(ConfigurationFile, WhatIsNoYamlNamesLine) {
  EXPECT_THAT(Complaint("ndt:\n  min_points: [5\n"), testing::StartsWith("test.yaml:"));
  EXPECT_THAT(Complaint("ndt:\n  min_points: [5\n"), HasSubstr("no valid YAML"));
}

TEST(Configuration, FileThatIsNotThereIsNamed) {
  try {
    LoadConfiguration("/nowhere/test.yaml");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/test.yaml: cannot be read"));
  }
}

TEST(Configuration, WithoutAFileAllIsDefault) {
  const Configuration config = LoadConfiguration(std::nullopt);
  EXPECT_EQ(config.source, "");
  EXPECT_EQ(config.SegmentationOver({}), SegmentationConfig{});
}

TEST_F(ConfigurationFile, PathsAreRelativeToTheFile) {
  const Configuration config = Load("files: {model: a.model, environment_map: /maps/b.map}\n");
  EXPECT_EQ(config.files.model, (folder_ / "a.model").string());
  EXPECT_EQ(config.files.environment_map, "/maps/b.map");
}

TEST_F(ConfigurationFile, SegmentationOverridesTheModelsAndNullKeepsThem) {
  const Configuration config = Load("segmentation: {min_score: 0.25, min_cluster_cells: null}\n");
  SegmentationConfig model;
  model.min_score = -0.5;
  model.min_cluster_cells = 99;
  model.cluster_epsilon_m = 0.2;
  SegmentationConfig expected = model;
  expected.min_score = 0.25;
  EXPECT_EQ(config.SegmentationOver(model), expected);
}

}  // namespace
}  // namespace fallen
