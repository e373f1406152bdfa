// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/listen/decision_tally.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

Decision With(std::initializer_list<std::pair<double, bool>> persons) {
  Decision decision;
  decision.frame = MapFrame::kWorld;
  for (const auto& [probability, is_person] : persons) {
    PersonHypothesis hypothesis;
    hypothesis.probability = probability;
    hypothesis.is_person = is_person;
    hypothesis.cell_count = 250;
    decision.hypotheses.push_back(hypothesis);
  }
  return decision;
}

TEST(DecisionTally, AFrameWithoutADecisionIsLost) {
  DecisionTally tally;
  for (std::int64_t seq = 0; seq < 3; ++seq) tally.AddFrame({1000 + seq, seq, "CAMERA"});
  tally.AddDecision({1000, 0, "CAMERA"}, With({{0.9, true}, {0.8, true}}));
  tally.AddDecision({1002, 2, "CAMERA"}, With({{0.3, false}}));
  EXPECT_EQ(tally.lost(), 1);
  EXPECT_EQ(tally.Summary(), "frames 3 decisions 2 lost 1 persons 1");
  EXPECT_EQ(tally.best_probability(), 0.9);
}

TEST(DecisionTally, ADecisionThatComesTwiceCountsOnce) {
  DecisionTally tally;
  tally.AddFrame({5, 0, "CAMERA"});
  tally.AddDecision({5, 0, "CAMERA"}, With({{0.9, true}}));
  tally.AddDecision({5, 0, "CAMERA"}, With({{0.9, true}}));
  tally.AddDamaged();
  EXPECT_EQ(tally.Summary(), "frames 1 decisions 1 lost 0 persons 1 damaged 1");
}

TEST(DecisionTally, DescribesOnlyWhoWasAccepted) {
  const Header header{3500000, 17, "CAMERA"};
  EXPECT_EQ(DescribeDecision(header, With({{0.2, false}}), 1000000), "");
  EXPECT_EQ(
      DescribeDecision(header, With({{0.25, true}}), 1000000),
      "   2.50 s  frame   17  fallen person at (0.00, 0.00, 0.00) m world  p 0.250  250 cells");
}

TEST(DecisionTally, DescribesAlarms) {
  FallAlarm alarm;
  alarm.id = "r2-7";
  alarm.change_utime = 3500000;
  alarm.position = {1.25, -2, 0.5};
  alarm.probability = 0.97;
  alarm.views = 2;
  EXPECT_EQ(DescribeAlarm(alarm, 1000000),
            "   2.50 s  ALARM r2-7 raised at (1.25, -2.00, 0.50) m world  p 0.970  2 views");
}

}  // namespace
}  // namespace fallen
