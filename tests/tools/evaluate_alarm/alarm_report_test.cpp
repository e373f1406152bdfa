// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_alarm/alarm_report.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

DriveOutcome Fall(std::optional<double> seconds_until, int views, int false_alarms) {
  DriveOutcome drive;
  drive.log = "a.lcm";
  drive.seconds = 360;
  drive.has_person = drive.came_into_view = true;
  drive.alarm = {seconds_until, views, false_alarms, std::nullopt};
  drive.single_frame = {0.1, 1, 3, std::nullopt};
  return drive;
}

TEST(AlarmReport, SumsUpDrives) {
  DriveOutcome person_free;
  person_free.seconds = 720;
  person_free.alarm.false_alarms = 1;
  DriveOutcome left = Fall(2, 4, 0);
  left.person_left = true;
  left.alarm.seconds_until_cleared = 2.5;
  const std::vector<DriveOutcome> drives = {Fall(1, 2, 0), left, Fall(4, 3, 1),
                                            Fall(std::nullopt, 0, 0), person_free};
  const auto figures = AlarmFigures(drives);
  EXPECT_EQ(figures["drives"], 5);
  EXPECT_DOUBLE_EQ(figures["hours"], 0.6);
  EXPECT_EQ(figures["falls"], 4);
  EXPECT_EQ(figures["person_free_drives"], 1);
  EXPECT_DOUBLE_EQ(figures["person_free_hours"], 0.2);
  const auto& alarm = figures["alarm"];
  EXPECT_EQ(alarm["found"], 3);
  EXPECT_EQ(alarm["share_found"], 0.75);
  EXPECT_EQ(alarm["share_within_3_s"], 0.5);
  EXPECT_EQ(alarm["median_seconds"], 2.0);
  EXPECT_TRUE(alarm["p90_seconds"].is_null()) << "one in four was never found";
  EXPECT_EQ(alarm["median_views"], 3.0);
  EXPECT_EQ(alarm["false_alarms"], 2);
  EXPECT_DOUBLE_EQ(alarm["false_alarms_per_hour"], 2 / 0.6);
  EXPECT_EQ(alarm["person_free_false_alarms"], 1);
  EXPECT_DOUBLE_EQ(alarm["person_free_false_alarms_per_hour"], 5);
  EXPECT_EQ(alarm["left"], 1);
  EXPECT_EQ(alarm["cleared"], 1);
  EXPECT_EQ(alarm["median_seconds_until_cleared"], 2.5);
  EXPECT_EQ(figures["single_frame"]["found"], 4);
  EXPECT_EQ(figures["single_frame"]["false_alarms"], 12);
  EXPECT_EQ(DriveList(drives).size(), 5U);
  EXPECT_TRUE(DriveList(drives)[3]["alarm"]["seconds_until"].is_null());
}

TEST(AlarmReport, WithoutFallsSharesAreNull) {
  const auto figures = AlarmFigures(std::vector<DriveOutcome>{DriveOutcome{}});
  EXPECT_TRUE(figures["alarm"]["share_found"].is_null());
  EXPECT_TRUE(figures["alarm"]["median_seconds"].is_null());
  EXPECT_TRUE(figures["alarm"]["false_alarms_per_hour"].is_null());
}

}  // namespace
}  // namespace fallen
