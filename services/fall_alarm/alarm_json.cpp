// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/alarm_json.hpp"

namespace fallen {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

Json AlarmJson(const NumberedAlarm& numbered) {
  const FallAlarm& alarm = numbered.alarm;
  return {{"event_type", EnumName(alarm.change)},
          {"event_id", alarm.id},
          {"revision", alarm.revision},
          {"number", numbered.number},
          {"robot", numbered.robot},
          {"camera", alarm.camera},
          {"utime", alarm.change_utime},
          {"first_utime", alarm.first_utime},
          {"raised_utime", alarm.raised_utime},
          {"acknowledged_utime", alarm.acknowledged_utime},
          {"acknowledged_by", alarm.acknowledged_by},
          {"cleared_utime", alarm.cleared_utime},
          {"cleared_by", alarm.cleared_by},
          {"frame", EnumName(alarm.frame)},
          {"position", ToJson(alarm.position)},
          {"box",
           {{"center", ToJson(alarm.box.center)},
            {"size", ToJson(alarm.box.size)},
            {"yaw", alarm.box.yaw}}},
          {"probability", alarm.probability},
          {"best_probability", alarm.best_probability},
          {"views", alarm.views},
          {"frames", alarm.frames}};
}

Json ActiveAlarmsJson(std::span<const NumberedAlarm> alarms) {
  Json list = Json::array();
  for (const NumberedAlarm& alarm : alarms) list.push_back(AlarmJson(alarm));
  return {{"active", alarms.size()}, {"alarms", std::move(list)}};
}

std::string JsonLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace fallen
