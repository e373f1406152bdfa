// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>

#include "fallen/messages/baseline_files.hpp"
#include "fallen/messages/container_file.hpp"
#include "fallen/messages/log_file.hpp"
#include "message_samples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using samples::SampleBaselineModel;

void ExpectEqual(const BaselineModel& a, const BaselineModel& b) {
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.config, b.config);
  EXPECT_EQ(a.trees, b.trees);
  EXPECT_EQ(a.calibration, b.calibration);
}

TEST(BaselineModelConversion, RefusesEachBadField) {
  const std::pair<const char*, std::function<void(baseline_model_t&)>> cases[] = {
      {"description", [](auto& m) { m.description = "\x03"; }},
      {"leaf_m", [](auto& m) { m.leaf_m = 0; }},
      {"max_height_m", [](auto& m) { m.max_height_m = std::numeric_limits<double>::quiet_NaN(); }},
      {"layers", [](auto& m) { m.layers = 1 << 30; }},
      {"features", [](auto& m) { m.layers = 3; }},
      {"normal_bins", [](auto& m) { m.normal_bins = -1; }},
      {"trees.tree_count", [](auto& m) { m.trees.tree_count = 3; }},
      {"boosted_trees", [](auto& m) { m.trees.node_left[0] = 0; }},
      {"slope", [](auto& m) { m.calibration_slope = -1; }},
      {"operating_point_count", [](auto& m) { m.operating_point_count = 3; }},
      {"miss_rate", [](auto& m) { m.operating_point_miss_rate[0] = 2; }},
  };
  for (const auto& [what, spoil] : cases) {
    baseline_model_t message = ToMessage(SampleBaselineModel());
    spoil(message);
    try {
      FromMessage(message);
      ADD_FAILURE() << what << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(what));
    }
  }
}

class BaselineModelFile : public testing::Test {
 protected:
  std::string LoadError() const {
    try {
      LoadBaselineModel(path_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "baseline.model";
};

TEST_F(BaselineModelFile, GivesBackWhatWasSaved) {
  SaveBaselineModel(path_, SampleBaselineModel());
  ExpectEqual(LoadBaselineModel(path_), SampleBaselineModel());
}

TEST_F(BaselineModelFile, NamesWhatIsWrong) {
  EXPECT_EQ(LoadError(), path_.string() + ": cannot open: No such file or directory");
  const auto content = EncodeMessage(ToMessage(SampleBaselineModel()));
  WriteContainer(path_, {"FALLENMD", "", 1}, content);
  EXPECT_EQ(LoadError(), path_.string() +
                             ": first bytes: got \"FALLENMD\", expected \"FALLENBM\" of a "
                             "baseline model file");
  WriteContainer(path_, {"FALLENBM", "", 7}, content);
  EXPECT_EQ(LoadError(), path_.string() + ": version: got 7, expected 1");
}

TEST_F(BaselineModelFile, RefusesEveryDamagedByte) {
  SaveBaselineModel(path_, SampleBaselineModel());
  const std::string whole = ReadText(path_);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    folder_.Write("baseline.model", damaged);
    EXPECT_THAT(LoadError(), testing::StartsWith(path_.string() + ": ")) << i;
  }
  folder_.Write("baseline.model", whole.substr(0, whole.size() / 2));
  EXPECT_THAT(LoadError(), testing::HasSubstr(": size: got "));
}

}  // namespace
}  // namespace fallen
