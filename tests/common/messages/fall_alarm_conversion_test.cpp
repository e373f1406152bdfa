// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "fallen/messages/conversions.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

template <class Message>
void ExpectRefused(Message message, const char* field, const std::function<void(Message&)>& spoil) {
  spoil(message);
  try {
    FromMessage(message);
    ADD_FAILURE() << field << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::StartsWith(field), testing::HasSubstr(": got "),
                               testing::HasSubstr(", expected ")));
  }
}

TEST(FallAlarmConversion, RoundTripIsExact) {
  const NumberedAlarm value = samples::SampleAlarm();
  EXPECT_EQ(FromMessage(ToMessage(value)), value);
  const fall_alarm_t message = ToMessage(value);
  EXPECT_EQ(message.header.utime, value.alarm.change_utime);
  EXPECT_EQ(message.header.seq, value.number);
  EXPECT_EQ(message.header.sensor_name, value.alarm.camera);
}

TEST(FallAlarmConversion, RefusesEachBadField) {
  using Spoil = std::function<void(fall_alarm_t&)>;
  const std::pair<const char*, Spoil> cases[] = {
      {"header_t.seq", [](auto& m) { m.header.seq = -1; }},
      {"fall_alarm_t.robot", [](auto& m) { m.robot = std::string(99, 'a'); }},
      {"fall_alarm_t.event_id", [](auto& m) { m.event_id.clear(); }},
      {"fall_alarm_t.event_id", [](auto& m) { m.event_id = "\x01"; }},
      {"fall_alarm_t.revision", [](auto& m) { m.revision = -1; }},
      {"fall_alarm_t.change", [](auto& m) { m.change = 4; }},
      {"fall_alarm_t.first_utime", [](auto& m) { m.first_utime = -1; }},
      {"fall_alarm_t.raised_utime", [](auto& m) { m.raised_utime = -1; }},
      {"fall_alarm_t.acknowledged_utime", [](auto& m) { m.acknowledged_utime = -1; }},
      {"fall_alarm_t.acknowledged_by", [](auto& m) { m.acknowledged_by = "\x7f"; }},
      {"fall_alarm_t.cleared_utime", [](auto& m) { m.cleared_utime = -1; }},
      {"fall_alarm_t.cleared_by", [](auto& m) { m.cleared_by = std::string(999, 'a'); }},
      {"fall_alarm_t.frame", [](auto& m) { m.frame = 3; }},
      {"fall_alarm_t.position", [](auto& m) { m.position[1] = NAN; }},
      {"fall_alarm_t.box", [](auto& m) { m.box.size[0] = -1; }},
      {"fall_alarm_t.probability", [](auto& m) { m.probability = 1.1; }},
      {"fall_alarm_t.best_probability", [](auto& m) { m.best_probability = NAN; }},
      {"fall_alarm_t.views", [](auto& m) { m.views = -1; }},
      {"fall_alarm_t.frames", [](auto& m) { m.frames = -1; }},
  };
  for (const auto& [field, spoil] : cases)
    ExpectRefused<fall_alarm_t>(ToMessage(samples::SampleAlarm()), field, spoil);
}

TEST(AlarmAnswerConversion, RoundTripIsExact) {
  const AlarmAnswer value = samples::SampleAnswer();
  EXPECT_EQ(FromMessage(ToMessage(value)), value);
  EXPECT_EQ(FromMessage(ToMessage(AlarmAnswer{})), AlarmAnswer{});
}

TEST(AlarmAnswerConversion, RefusesEachBadField) {
  using Spoil = std::function<void(fall_alarm_ack_t&)>;
  const std::pair<const char*, Spoil> cases[] = {
      {"header_t.utime", [](auto& m) { m.header.utime = -1; }},
      {"fall_alarm_ack_t.event_id", [](auto& m) { m.event_id = "\x01"; }},
      {"fall_alarm_ack_t.by", [](auto& m) { m.by = std::string(999, 'a'); }},
      {"fall_alarm_ack_t.action", [](auto& m) { m.action = 2; }},
  };
  for (const auto& [field, spoil] : cases)
    ExpectRefused<fall_alarm_ack_t>(ToMessage(samples::SampleAnswer()), field, spoil);
}

}  // namespace
}  // namespace fallen
