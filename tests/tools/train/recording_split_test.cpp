// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/recording_split.hpp"

#include <gtest/gtest.h>

#include <set>

namespace fallen {
namespace {

TEST(RecordingSplit, NoPersonAndNoRoomIsOnBothSides) {
  std::vector<RecordingOrigin> recordings;
  for (int i = 0; i < 60; ++i) {
    const int home = i / 4;  // four recordings a home, two persons a home
    recordings.push_back({"log-" + std::to_string(i),
                          i % 4 == 3 ? "" : "person-" + std::to_string(home * 2 + i % 2),
                          "room-" + std::to_string(home)});
  }
  const RecordingSplit split = SplitByPersonAndRoom(recordings, 0.25, 7);
  EXPECT_EQ(split.training.size() + split.validation.size(), recordings.size());
  EXPECT_NEAR(static_cast<double>(split.validation.size()), 15, 4);
  std::vector<RecordingOrigin> training, validation;
  for (const std::size_t i : split.training) training.push_back(recordings[i]);
  for (const std::size_t i : split.validation) validation.push_back(recordings[i]);
  EXPECT_NO_THROW(RequireDisjoint(training, validation));
}

TEST(RecordingSplit, DependsOnTheSeedAlone) {
  std::vector<RecordingOrigin> recordings;
  for (int i = 0; i < 20; ++i) recordings.push_back({"", "", "room-" + std::to_string(i)});
  const RecordingSplit first = SplitByPersonAndRoom(recordings, 0.3, 1);
  EXPECT_EQ(first.validation, SplitByPersonAndRoom(recordings, 0.3, 1).validation);
  EXPECT_NE(first.validation, SplitByPersonAndRoom(recordings, 0.3, 2).validation);
}

TEST(RecordingSplit, RefusesRecordingsThatHangTogether) {
  const std::vector<RecordingOrigin> chain{{"a", "p1", "r1"}, {"b", "p2", "r1"}, {"c", "p2", "r2"}};
  EXPECT_THROW(SplitByPersonAndRoom(chain, 0.3, 1), std::invalid_argument);
  EXPECT_THROW(SplitByPersonAndRoom({}, 0.3, 1), std::invalid_argument);
  EXPECT_THROW(SplitByPersonAndRoom({{"", "", "1"}, {"", "", "2"}}, 1.0, 1), std::invalid_argument);
}

TEST(RecordingSplit, NeitherSideIsEmpty) {
  const std::vector<RecordingOrigin> two{{"a", "p1", "r1"}, {"b", "p2", "r2"}};
  for (const double share : {0.01, 0.99}) {
    const RecordingSplit split = SplitByPersonAndRoom(two, share, 3);
    EXPECT_EQ(split.training.size(), 1u);
    EXPECT_EQ(split.validation.size(), 1u);
  }
}

TEST(RecordingSplit, NamesThePersonOnBothSides) {
  try {
    RequireDisjoint({{"a", "p1", "r1"}}, {{"b", "p1", "r2"}});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "b: person p1 is in the training set too, expected an unseen one");
  }
}

}  // namespace
}  // namespace fallen
