// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-evaluate-alarm, as somebody calls it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "fallen/messages/model_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"

namespace fallen {
namespace {

using lying_scene::With;
using nlohmann::json;
using testing::HasSubstr;

class EvaluateAlarmProgram : public testing::Test {
 protected:
  void SetUp() override {
    lying_scene::WriteDirectory(folder_ / "person", 4, With::kPerson, true);
    lying_scene::WriteLabels(folder_ / "person", With::kPerson);
    SaveModel(folder_ / "plain.model", PlainModel());
  }

  ProgramOutcome Run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {Path("person"), "--model", Path("plain.model"), "--json",
                                         Path("figures.json"), "--jobs", "1"});
    return RunProgram("fallen-evaluate-alarm", arguments);
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(EvaluateAlarmProgram, JudgesSeveralAlarmsOnTheSameDecisions) {
  // Four frames are too few by default.
  const std::string eager =
      folder_
          .Write("eager.yaml",
                 "alarm: {neutral_probability: 0.001, raise_log_odds: 0.1, on_delay_s: 0}\n")
          .string();
  const std::string never = folder_.Write("never.yaml", "alarm: {raise_log_odds: 99}\n").string();
  const ProgramOutcome outcome = Run({"--compare", eager, "--compare", never});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json report = json::parse(ReadText(folder_ / "figures.json"));
  EXPECT_EQ(report.at("falls"), 1);
  EXPECT_EQ(report.at("single_frame").at("found"), 1);
  EXPECT_EQ(report.at("alarm").at("found"), 0);
  EXPECT_EQ(report.at("compared").at(eager).at("found"), 1);
  EXPECT_EQ(report.at("compared").at(never).at("found"), 0);
  EXPECT_EQ(report.at("sequences").size(), 1u);
}

TEST_F(EvaluateAlarmProgram, WithoutComparedConfigurationsThereAreNone) {
  ASSERT_EQ(Run({}).status, 0);
  EXPECT_FALSE(json::parse(ReadText(folder_ / "figures.json")).contains("compared"));
}

TEST_F(EvaluateAlarmProgram, AWrongComparedConfigurationIsOneLineAndStatusTwo) {
  const std::string wrong = folder_.Write("wrong.yaml", "alarm: {memory_s: -1}\n").string();
  const ProgramOutcome outcome = Run({"--compare", wrong});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("memory_s"));
}

}  // namespace
}  // namespace fallen
