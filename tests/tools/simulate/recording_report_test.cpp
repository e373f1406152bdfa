// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/recording_report.hpp"

#include <nlohmann/json.hpp>

#include "tests/tools/simulate/assets_fixture.hpp"

namespace fallen::sim {
namespace {

using RecordingReportTest = WithAssets;

nlohmann::json Report(const std::string& scenario, const Assets& assets) {
  const Simulation simulation(ParseScenario(scenario, "s.yaml", {}), assets);
  return nlohmann::json::parse(DescribeRecording(simulation));
}

TEST_F(RecordingReportTest, SomebodyOnAnEmptyFloorIsWhollyVisible) {
  const nlohmann::json report = Report(
      "{seed: 3, person: true, pose: supine, furnished: false, distractors: [], blanket: false, "
      "placement: free, frames: 11}",
      assets());
  EXPECT_EQ(report["scenario"]["pose"], "supine");
  EXPECT_EQ(report["placement"], "free");
  EXPECT_LE(report["sink_m"].get<double>(), 0.02);
  EXPECT_LT(report["height_m"].get<double>(), 0.4);
  ASSERT_EQ(report["visible_share"].size(), 3u);
  int whole = 0;
  for (const auto& share : report["visible_share"]) {
    EXPECT_TRUE(share == 0.0 || share > 0.99) << share;  // out of view or nothing before it
    whole += share > 0.99;
  }
  EXPECT_GT(whole, 0);
}

TEST_F(RecordingReportTest, AnEmptyRoomHasNoPerson) {
  const nlohmann::json report =
      Report("{seed: 3, person: false, distractors: [], frames: 1}", assets());
  EXPECT_FALSE(report.contains("visible_share"));
  for (const auto& category : report["objects"]) EXPECT_EQ(category, "furniture");
}

TEST_F(RecordingReportTest, ABlanketHidesLegs) {
  const std::string scenario =
      "{seed: 3, person: true, pose: supine, furnished: false, distractors: [], placement: free, "
      "frames: 1, blanket: ";
  const nlohmann::json bare = Report(scenario + "false}", assets());
  const nlohmann::json covered = Report(scenario + "true}", assets());
  EXPECT_LT(covered["visible_share"][0].get<double>(),
            bare["visible_share"][0].get<double>() - 0.1);
  EXPECT_EQ(covered["objects"].back(), "blanket");
}

}  // namespace
}  // namespace fallen::sim
