// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/scenario.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace fallen::sim {
namespace {

using testing::HasSubstr;

std::string ErrorOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    ParseScenario(text, "s.yaml", overrides);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Scenario, SeedAloneIsEnoughAndDecidesAll) {
  const Scenario a = ParseScenario("seed: 7", "s.yaml", {}),
                 b = ParseScenario("seed: 7", "s.yaml", {});
  EXPECT_EQ(DescribeScenario(a), DescribeScenario(b));
  EXPECT_NE(DescribeScenario(a), DescribeScenario(ParseScenario("seed: 8", "s.yaml", {})));
}

TEST(Scenario, FixingOneKeyLeavesTheOthers) {
  const Scenario a = ParseScenario("seed: 7\nperson: true", "s.yaml", {});
  const Scenario b = ParseScenario("seed: 7\nperson: true\nbody: 5", "s.yaml", {});
  EXPECT_EQ(b.body, 5);
  EXPECT_EQ(a.room, b.room);
  EXPECT_EQ(a.pose, b.pose);
  EXPECT_EQ(a.distractors, b.distractors);
  EXPECT_EQ(a.camera_height_m, b.camera_height_m);
}

TEST(Scenario, ReadsItsOwnDescription) {
  const Scenario a =
      ParseScenario("seed: 9\nyaw_deg: 30\ndistractors: [cat, blanket]", "s.yaml", {});
  EXPECT_EQ(DescribeScenario(ParseScenario(DescribeScenario(a), "s.yaml", {})),
            DescribeScenario(a));
}

TEST(Scenario, SettingsOverrideTheFile) {
  const Scenario scenario = ParseScenario("frames: 10\npose: prone", "s.yaml",
                                          {"frames=20", "pose=curled_left", "distractors=[dog]"});
  EXPECT_EQ(scenario.frames, 20);
  EXPECT_EQ(scenario.pose, PoseFamily::kCurledLeft);
  EXPECT_THAT(scenario.distractors, testing::ElementsAre("dog"));
}

TEST(Scenario, RandomDistractorsAreTheSameAsNone) {
  EXPECT_EQ(DescribeScenario(ParseScenario("seed: 4\ndistractors: random", "s.yaml", {})),
            DescribeScenario(ParseScenario("seed: 4", "s.yaml", {})));
}

TEST(Scenario, AnEmptyFileIsAScenario) { EXPECT_EQ(ParseScenario("", "s.yaml", {}).seed, 1); }

TEST(Scenario, ErrorsNameFileLineKeyAndWhatWasExpected) {
  EXPECT_THAT(ErrorOf("seed: 1\nperson: true\ncolour: red"), HasSubstr("s.yaml:3: colour"));
  EXPECT_THAT(ErrorOf("seed: 1\npose: dancing"),
              HasSubstr("s.yaml:2: pose: got 'dancing', expected one of"));
  EXPECT_THAT(ErrorOf("frames: many"), HasSubstr("s.yaml:1: frames: got 'many'"));
  EXPECT_THAT(ErrorOf("gets_up_after_s: 0"),
              HasSubstr("gets_up_after_s: got 0, expected a number > 0"));
  EXPECT_THAT(ErrorOf("frames: 0"), HasSubstr("frames: got 0, expected 1 to"));
  EXPECT_THAT(ErrorOf("seed: 1\nwidth: 500"),
              HasSubstr("s.yaml:2: width: got 500, expected 320 or 640"));
  EXPECT_THAT(ErrorOf("camera_pitch_deg: .nan"), HasSubstr("camera_pitch_deg"));
  EXPECT_THAT(ErrorOf("distractors: [dog, unicorn]"), HasSubstr("got unicorn, expected one of"));
  EXPECT_THAT(ErrorOf("- a\n- b"), HasSubstr("expected a map"));
  EXPECT_THAT(ErrorOf("seed: [1"), HasSubstr("s.yaml:"));
  EXPECT_THAT(ErrorOf("seed: 1\nseed: 2"), HasSubstr("twice"));
  EXPECT_THAT(ErrorOf("", {"frames"}), HasSubstr("got 'frames', expected key=value"));
}

TEST(Scenario, AMissingFileIsNamed) {
  try {
    LoadScenario("/nowhere/s.yaml", {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/s.yaml: got no such file"));
  }
}

}  // namespace
}  // namespace fallen::sim
