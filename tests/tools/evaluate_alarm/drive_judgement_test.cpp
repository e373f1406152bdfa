// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_alarm/drive_judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/seen_place.hpp"

namespace fallen {
namespace {

using seen_place::AddCluster;
using seen_place::Empty;
using seen_place::LookAt;

const OrientedBox kBox{{2, 0, 0.15}, {1.6, 0.5, 0.3}, 0};

/// A drive at 10 Hz round the person, who comes into view at `view_s` and leaves at `left_s`.
DriveTrace Drive(double seconds, double view_s, double left_s,
                 const std::function<void(double, Decision&)>& clusters_at) {
  DriveTrace trace;
  trace.camera = "FRONT";
  for (int i = 0; i < std::lround(10 * seconds); ++i) {
    const double t = 0.1 * i;
    const double angle = 0.3 * t;
    TracedFrame frame;
    frame.utime = 1'700'000'000'000'000 + i * 100'000;
    frame.decision = Empty(LookAt({2 - 2 * std::cos(angle), 2 * std::sin(angle), 1}, kBox.center));
    if (t < left_s) frame.person_box = kBox;
    frame.is_in_view = t >= view_s && t < left_s;
    clusters_at(t, frame.decision);
    trace.frames.push_back(frame);
  }
  return trace;
}

DriveOutcome Judge(const DriveTrace& trace) { return JudgeDrive(trace, AlarmFusion({}, {})); }

TEST(DriveJudgement, FindsThePersonAndTellsHowLongItTook) {
  const DriveOutcome outcome = Judge(Drive(8, 1, 100, [](double t, Decision& decision) {
    if (t > 1.95) AddCluster(decision, kBox.center, 0.99);
  }));
  EXPECT_NEAR(outcome.seconds, 8, 1e-6);
  EXPECT_TRUE(outcome.has_person);
  EXPECT_TRUE(outcome.came_into_view);
  EXPECT_FALSE(outcome.person_left);
  ASSERT_TRUE(outcome.single_frame.seconds_until && outcome.alarm.seconds_until);
  EXPECT_NEAR(*outcome.single_frame.seconds_until, 1.0, 1e-6);
  EXPECT_GT(*outcome.alarm.seconds_until, 1.2);
  EXPECT_LT(*outcome.alarm.seconds_until, 3);
  EXPECT_GE(outcome.alarm.views, 1);
  EXPECT_EQ(outcome.alarm.false_alarms + outcome.single_frame.false_alarms, 0);
}

TEST(DriveJudgement, BeforeEnoughIsInViewIsAtOnce) {
  const DriveOutcome outcome = Judge(Drive(
      8, 6, 100, [](double, Decision& decision) { AddCluster(decision, kBox.center, 0.99); }));
  EXPECT_EQ(outcome.alarm.seconds_until, 0.0);
  EXPECT_EQ(outcome.single_frame.seconds_until, 0.0);
}

TEST(DriveJudgement, OneFrameFoolsSingleDecisionsOnly) {
  const DriveOutcome outcome = Judge(Drive(8, 100, 0, [](double t, Decision& decision) {
    if (std::abs(t - 2) < 0.01 || std::abs(t - 4) < 0.01) AddCluster(decision, {1, 0, 0.1}, 0.99);
    if (std::abs(t - 6) < 0.01) AddCluster(decision, {2, 1, 0.1}, 0.99);
  }));
  EXPECT_FALSE(outcome.has_person);
  EXPECT_FALSE(outcome.came_into_view);
  EXPECT_EQ(outcome.single_frame.false_alarms, 2) << "the same place counts once";
  EXPECT_EQ(outcome.alarm.false_alarms, 0);
}

TEST(DriveJudgement, SomethingThatLooksLikeAPersonFoolsBoth) {
  const DriveOutcome outcome = Judge(Drive(8, 1, 100, [](double, Decision& decision) {
    AddCluster(decision, {2, 1.2, 0.1}, 0.99);
  }));
  EXPECT_EQ(outcome.alarm.false_alarms, 1);
  EXPECT_EQ(outcome.single_frame.false_alarms, 1);
  EXPECT_FALSE(outcome.alarm.seconds_until);
  EXPECT_FALSE(outcome.single_frame.seconds_until);
}

TEST(DriveJudgement, TellsHowLongTheAlarmStaysAfterThePersonHasLeft) {
  const DriveOutcome outcome = Judge(Drive(20, 0, 6, [](double t, Decision& decision) {
    if (t < 6) AddCluster(decision, kBox.center, 0.99);
  }));
  EXPECT_TRUE(outcome.person_left);
  ASSERT_TRUE(outcome.alarm.seconds_until_cleared);
  EXPECT_GT(*outcome.alarm.seconds_until_cleared, 1);
  EXPECT_LT(*outcome.alarm.seconds_until_cleared, 10);
}

}  // namespace
}  // namespace fallen
