// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "fallen/messages/box_conversion.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

constexpr std::int64_t kMaxInt32 = std::numeric_limits<std::int32_t>::max();

void CheckTimes(const fall_alarm_t& message) {
  checks::InRange("fall_alarm_t.first_utime", message.first_utime, 0, limits::kMaxTime);
  checks::InRange("fall_alarm_t.raised_utime", message.raised_utime, 0, limits::kMaxTime);
  checks::InRange("fall_alarm_t.acknowledged_utime", message.acknowledged_utime, 0,
                  limits::kMaxTime);
  checks::InRange("fall_alarm_t.cleared_utime", message.cleared_utime, 0, limits::kMaxTime);
}

void CheckTexts(const fall_alarm_t& message) {
  checks::CheckText("fall_alarm_t.robot", message.robot, limits::kMaxNameBytes);
  checks::CheckText("fall_alarm_t.event_id", message.event_id, limits::kMaxNameBytes * 2);
  if (message.event_id.empty()) checks::Fail("fall_alarm_t.event_id", "an empty text", "an id");
  checks::CheckText("fall_alarm_t.acknowledged_by", message.acknowledged_by,
                    limits::kMaxNameBytes * 2);
  checks::CheckText("fall_alarm_t.cleared_by", message.cleared_by, limits::kMaxNameBytes * 2);
}

}  // namespace

fall_alarm_t ToMessage(const NumberedAlarm& value) {
  const FallAlarm& alarm = value.alarm;
  fall_alarm_t message{};
  message.header = ToMessage(Header{alarm.change_utime, value.number, alarm.camera});
  message.robot = value.robot;
  message.event_id = alarm.id;
  message.revision = alarm.revision;
  message.change = static_cast<std::int8_t>(alarm.change);
  message.first_utime = alarm.first_utime;
  message.raised_utime = alarm.raised_utime;
  message.acknowledged_utime = alarm.acknowledged_utime;
  message.acknowledged_by = alarm.acknowledged_by;
  message.cleared_utime = alarm.cleared_utime;
  message.cleared_by = alarm.cleared_by;
  message.frame = static_cast<std::int32_t>(alarm.frame);
  std::copy_n(alarm.position.data(), 3, message.position);
  message.box = BoxToMessage("fall_alarm_t.box", alarm.box);
  message.probability = alarm.probability;
  message.best_probability = alarm.best_probability;
  message.views = alarm.views;
  message.frames = alarm.frames;
  FromMessage(message);
  return message;
}

NumberedAlarm FromMessage(const fall_alarm_t& message) {
  const Header header = FromMessage(message.header);
  CheckTexts(message);
  CheckTimes(message);
  checks::InRange("fall_alarm_t.revision", message.revision, 0, kMaxInt32);
  checks::InRange("fall_alarm_t.change", message.change, 0,
                  static_cast<int>(AlarmChange::kCleared));
  checks::InRange("fall_alarm_t.frame", message.frame, 0, static_cast<int>(MapFrame::kCamera));
  for (const double coordinate : message.position)
    checks::InRange("fall_alarm_t.position", coordinate, -limits::kMaxCoordinate_m,
                    limits::kMaxCoordinate_m);
  checks::InRange("fall_alarm_t.probability", message.probability, 0.0, 1.0);
  checks::InRange("fall_alarm_t.best_probability", message.best_probability, 0.0, 1.0);
  checks::InRange("fall_alarm_t.views", message.views, 0, kMaxInt32);
  checks::InRange("fall_alarm_t.frames", message.frames, 0, kMaxInt32);

  NumberedAlarm value;
  value.robot = message.robot;
  value.number = header.seq;
  FallAlarm& alarm = value.alarm;
  alarm.id = message.event_id;
  alarm.revision = message.revision;
  alarm.change = static_cast<AlarmChange>(message.change);
  alarm.change_utime = header.utime;
  alarm.camera = header.sensor_name;
  alarm.first_utime = message.first_utime;
  alarm.raised_utime = message.raised_utime;
  alarm.acknowledged_utime = message.acknowledged_utime;
  alarm.acknowledged_by = message.acknowledged_by;
  alarm.cleared_utime = message.cleared_utime;
  alarm.cleared_by = message.cleared_by;
  alarm.frame = static_cast<MapFrame>(message.frame);
  alarm.position = Eigen::Vector3d(message.position);
  alarm.box = BoxFromMessage("fall_alarm_t.box", message.box);
  alarm.probability = message.probability;
  alarm.best_probability = message.best_probability;
  alarm.views = message.views;
  alarm.frames = message.frames;
  return value;
}

fall_alarm_ack_t ToMessage(const AlarmAnswer& value) {
  fall_alarm_ack_t message{};
  message.header = ToMessage(Header{value.utime, 0, ""});
  message.event_id = value.event_id;
  message.by = value.by;
  message.action = value.closes ? fall_alarm_ack_t::CLOSE : fall_alarm_ack_t::ACKNOWLEDGE;
  FromMessage(message);
  return message;
}

AlarmAnswer FromMessage(const fall_alarm_ack_t& message) {
  const Header header = FromMessage(message.header);
  checks::CheckText("fall_alarm_ack_t.event_id", message.event_id, limits::kMaxNameBytes * 2);
  checks::CheckText("fall_alarm_ack_t.by", message.by, limits::kMaxNameBytes * 2);
  checks::InRange("fall_alarm_ack_t.action", message.action, fall_alarm_ack_t::ACKNOWLEDGE,
                  fall_alarm_ack_t::CLOSE);
  return {header.utime, message.event_id, message.by, message.action == fall_alarm_ack_t::CLOSE};
}

}  // namespace fallen
