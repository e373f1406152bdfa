// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/alarm_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fallen/messages/log_file.hpp"

namespace fallen {
namespace {

std::vector<std::uint8_t> AlarmOf(const std::string& id, std::int32_t revision,
                                  AlarmChange change) {
  NumberedAlarm numbered;
  numbered.robot = "robot";
  numbered.number = 1;
  FallAlarm& alarm = numbered.alarm;
  alarm.id = id;
  alarm.revision = revision;
  alarm.change = change;
  alarm.camera = "CAMERA";
  alarm.change_utime = alarm.raised_utime = alarm.first_utime = 1'000'000;
  if (change == AlarmChange::kCleared) alarm.cleared_utime = 2'000'000;
  alarm.box.size = {1, 1, 1};
  alarm.probability = alarm.best_probability = 0.9;
  alarm.views = alarm.frames = 1;
  return EncodeMessage(ToMessage(numbered));
}

TEST(AlarmTable, KeepsTheNewestOfEachFallAndIgnoresRepetitions) {
  AlarmTable table;
  EXPECT_TRUE(table.Take(AlarmOf("a", 0, AlarmChange::kRaised)));
  EXPECT_FALSE(table.Take(AlarmOf("a", 0, AlarmChange::kRaised)));
  EXPECT_TRUE(table.Take(AlarmOf("b", 0, AlarmChange::kRaised)));
  EXPECT_TRUE(table.Take(AlarmOf("a", 1, AlarmChange::kCleared)));
  EXPECT_FALSE(table.Take(AlarmOf("a", 0, AlarmChange::kRaised))) << "an old one comes late";
  const nlohmann::json json = table.ToJson();
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["id"], "b");
  EXPECT_EQ(json[1]["change"], "cleared");
  EXPECT_EQ(json[1]["cleared_utime"], 2'000'000);
}

TEST(AlarmTable, RefusesWhatIsNoAlarm) {
  AlarmTable table;
  EXPECT_THROW(table.Take(std::vector<std::uint8_t>(64, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
