// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-train --baseline and fallen-evaluate --baseline, as somebody calls them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fallen/messages/baseline_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"

namespace fallen {
namespace {

using lying_scene::With;
using testing::HasSubstr;

class BaselinePrograms : public testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [name, with] :
         {std::pair("person", With::kPerson), std::pair("nobody", With::kNobody)}) {
      lying_scene::WriteDirectory(folder_ / name, 4, with, true);
      lying_scene::WriteLabels(folder_ / name, with);
    }
    // A few frames hold few clusters: leaves of any weight, trees that need no more than one.
    settings_ = folder_.Write("baseline.yaml",
                              "sampling: {frame_stride: 1, validation_frame_stride: 1}\n"
                              "boosting: {rounds: 5, max_depth: 1}\n");
  }

  ProgramOutcome Train() const {
    return RunProgram("fallen-train",
                      {"--baseline", Log("person"), Log("nobody"), "--validation", Log("person"),
                       Log("nobody"), "--training", settings_.string(), "-o", model_.string()});
  }
  std::string Log(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
  std::filesystem::path settings_;
  std::filesystem::path model_ = folder_ / "baseline.model";
  std::filesystem::path json_ = folder_ / "figures.json";
};

TEST_F(BaselinePrograms, WhatIsTrainedIsMeasured) {
  const ProgramOutcome trained = Train();
  ASSERT_EQ(trained.status, 0) << trained.err;
  EXPECT_EQ(LoadBaselineModel(model_).trees.roots.size(), 5u);

  const ProgramOutcome measured = RunProgram(
      "fallen-evaluate", {Log("person"), Log("nobody"), "--json", json_.string(), "--baseline",
                          "--baseline-model", model_.string(), "--resamples", "10"});
  ASSERT_EQ(measured.status, 0) << measured.err;
  const nlohmann::json report = nlohmann::json::parse(ReadText(json_));
  const nlohmann::json& baseline = report.at("baseline");
  const nlohmann::json& detector = report.at("detector");
  EXPECT_EQ(baseline.at("frames"), 8);
  EXPECT_EQ(baseline.at("positives"), 4);
  // The same frames count, whatever the method: cells are the local map's.
  EXPECT_EQ(baseline.at("positives"), detector.at("positives"));
  EXPECT_EQ(baseline.at("miss_rate_at_0.01_fppf"), 0);
  EXPECT_EQ(baseline.at("miss_rate_at_0.1_fppf"), 0);
  EXPECT_EQ(baseline.at("at_default_threshold").at("true_positives"), 4);
  EXPECT_EQ(baseline.at("at_default_threshold").at("false_positives"), 0);
  EXPECT_EQ(baseline.at("at_default_threshold").at("misses"), 0);
  EXPECT_TRUE(baseline.at("log_average_miss_rate").is_number());
  EXPECT_EQ(report.at("sequences").size(), 2u);
}

TEST_F(BaselinePrograms, TheFlagTakesNoValueAndTheShippedModelIsFound) {
  const ProgramOutcome measured = RunProgram(
      "fallen-evaluate", {Log("person"), "--baseline", Log("nobody"), "--json", json_.string()});
  ASSERT_EQ(measured.status, 0) << measured.err;
  EXPECT_EQ(nlohmann::json::parse(ReadText(json_)).at("baseline").at("frames"), 8);
}

TEST_F(BaselinePrograms, WithoutTheFlagThereIsNoBaseline) {
  const ProgramOutcome measured =
      RunProgram("fallen-evaluate", {Log("person"), "--json", json_.string()});
  ASSERT_EQ(measured.status, 0) << measured.err;
  EXPECT_FALSE(nlohmann::json::parse(ReadText(json_)).contains("baseline"));
}

TEST_F(BaselinePrograms, AWrongCallOrFileIsOneLineAndStatusTwo) {
  const auto damaged = folder_.Write("damaged.model", "FALLENBM").string();
  const std::string settings = folder_.Write("wrong.yaml", "baseline: {leaf_m: -1}\n").string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls = {
      {{"fallen-evaluate", Log("person"), "--baseline", "--baseline-model", damaged}, damaged},
      {{"fallen-evaluate", Log("person"), "--baseline", "--baseline-model", "/nowhere"},
       "/nowhere"},
      {{"fallen-evaluate", Log("person"), "--baseline-model", damaged}, "--baseline"},
      {{"fallen-train", "--baseline", Log("person"), "-o", Log("x"), "--training", settings},
       "leaf_m"},
      {{"fallen-train", "--baseline", Log("missing"), "-o", Log("x")}, "missing"}};
  for (const auto& [call, named] : calls) {
    const ProgramOutcome outcome = RunProgram(call[0], {call.begin() + 1, call.end()});
    EXPECT_EQ(outcome.status, 2) << named;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(named));
  }
}

}  // namespace
}  // namespace fallen
