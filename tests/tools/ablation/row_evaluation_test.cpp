// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/row_evaluation.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"

namespace fallen {
namespace {

class RowEvaluation : public testing::Test {
 protected:
  RowEvaluation() {
    lying_scene::WriteDirectory(folder_.path(), 6, lying_scene::With::kPerson, true);
    const OrientedBox box = lying_scene::Person();
    std::ofstream(folder_.path() / "labels.yaml")
        << "person:\n  present: true\n  box: {center: [" << box.center.x() << ", " << box.center.y()
        << ", " << box.center.z() << "], size: [" << box.size.x() + 0.04 << ", "
        << box.size.y() + 0.04 << ", " << box.size.z() + 0.04 << "], yaw: " << box.yaw << "}\n";
    recordings_.accumulated.resize(1);
    recordings_.single.resize(1);
    ObservePair(folder_.path(), {}, {}, 2, recordings_.accumulated[0], recordings_.single[0]);
  }

  std::vector<SequenceOutcome> Judge(const AblationRow& row, const Backgrounds& backgrounds) {
    return JudgeRow(row, PlainModel(), recordings_, backgrounds, 1, [](const char*, double) {});
  }

  TemporaryFolder folder_;
  ObservedPairs recordings_;
};

TEST_F(RowEvaluation, MapsTheSameFramesBothWays) {
  const auto &accumulated = recordings_.accumulated[0], &single = recordings_.single[0];
  ASSERT_EQ(accumulated.frames.size(), 3u);
  ASSERT_EQ(single.frames.size(), 3u);
  EXPECT_GE(accumulated.frames[2].map.cells.size(), single.frames[2].map.cells.size());
  EXPECT_EQ(accumulated.frames[0].map.cells.size(), single.frames[0].map.cells.size());
}

TEST_F(RowEvaluation, AMapOfTheRoomTakesAwayWhatIsKnown) {
  const TemporaryFolder room;
  lying_scene::WriteDirectory(room.path(), 6, lying_scene::With::kNobody, true);
  lying_scene::WriteLabels(room.path(), lying_scene::With::kNobody);
  recordings_.accumulated[0] = {};
  recordings_.single[0] = {};
  ObservePair(room.path(), {}, {}, 2, recordings_.accumulated[0], recordings_.single[0]);
  EnvironmentMap wall;
  for (const ObservedFrame& frame : recordings_.accumulated[0].frames)
    wall.cells.insert(wall.cells.end(), frame.map.cells.begin(), frame.map.cells.end());
  AblationRow row;
  const auto without = Judge(row, {});
  Backgrounds backgrounds;
  backgrounds[MapAge::kFresh].emplace_back(wall);
  row.map = MapAge::kFresh;
  const auto with = Judge(row, backgrounds);
  ASSERT_EQ(with[0].frames.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(without[0].frames[i].false_scores.empty());
    EXPECT_TRUE(with[0].frames[i].false_scores.empty());
  }
}

TEST_F(RowEvaluation, AMapOfTheRoomLeavesThePerson) {
  // The room's cells but for the person's: what is not in its box.
  EnvironmentMap room;
  for (const ObservedFrame& frame : recordings_.accumulated[0].frames)
    for (const NdtCell& cell : frame.map.cells)
      if (!frame.person_box->Contains(cell.mean.cast<double>())) room.cells.push_back(cell);
  Backgrounds backgrounds;
  backgrounds[MapAge::kFresh].emplace_back(room);
  AblationRow row;
  row.map = MapAge::kFresh;
  const auto outcomes = Judge(row, backgrounds);
  ASSERT_EQ(outcomes[0].frames.size(), 3u);
  for (const FrameOutcome& frame : outcomes[0].frames) {
    EXPECT_TRUE(frame.is_positive);
    EXPECT_TRUE(frame.hit_score);
    EXPECT_TRUE(frame.false_scores.empty());
  }
}

TEST_F(RowEvaluation, WithoutAccumulationThePersonsAreTheSame) {
  AblationRow row;
  row.accumulate = false;
  const auto outcomes = Judge(row, {});
  for (const FrameOutcome& frame : outcomes[0].frames) EXPECT_TRUE(frame.is_positive);
}

}  // namespace
}  // namespace fallen
