// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/mqtt_topics.hpp"

#include <nlohmann/json.hpp>

#include "fallen/alarm/fall_alarm.hpp"
#include "fallen/service/version.hpp"

namespace fallen {
namespace {

using Json = nlohmann::ordered_json;

/// What all entities say.
Json Entity(const std::string& robot, const std::string& kind, const std::string& name,
            const MqttTopics& topics) {
  const std::string identifier = "fallen_" + robot;
  return {{"name", name},
          {"unique_id", identifier + "_" + kind},
          {"availability_topic", topics.availability},
          {"payload_available", "online"},
          {"payload_not_available", "offline"},
          {"qos", 1},
          {"device",
           {{"identifiers", Json::array({identifier})},
            {"name", robot},
            {"manufacturer", "Fallen Person Detector contributors"},
            {"model", "Fallen Person Detector"},
            {"sw_version", Version()}}},
          {"origin", {{"name", "fallen-alarm"}, {"sw_version", Version()}}}};
}

}  // namespace

MqttTopics::MqttTopics(const std::string& topic, const std::string& robot) {
  const std::string base = topic + "/" + robot + "/";
  availability = base + "availability";
  alarm = base + "alarm";
  alarms = base + "alarms";
  event = base + "event";
  acknowledge = base + "acknowledge";
  close = base + "close";
}

std::vector<MqttMessage> HomeAssistantDiscovery(const std::string& prefix, const std::string& robot,
                                                const MqttTopics& topics) {
  if (prefix.empty()) return {};
  const auto topic = [&](const std::string& component, const std::string& kind) {
    return prefix + "/" + component + "/fallen_" + robot + "/" + kind + "/config";
  };
  Json alarm = Entity(robot, "alarm", "Fallen person", topics);
  alarm["device_class"] = "safety";
  alarm["state_topic"] = topics.alarm;
  alarm["payload_on"] = "ON";
  alarm["payload_off"] = "OFF";
  alarm["json_attributes_topic"] = topics.alarms;

  Json event = Entity(robot, "event", "Fall alarm event", topics);
  event["state_topic"] = topics.event;
  Json types = Json::array();
  for (const auto& [change, name] : EnumNames(AlarmChange{})) types.push_back(name);
  event["event_types"] = std::move(types);

  Json button = Entity(robot, "acknowledge", "Acknowledge fall alarms", topics);
  button["command_topic"] = topics.acknowledge;
  button["payload_press"] = "all";

  return {{topic("binary_sensor", "alarm"), alarm.dump()},
          {topic("event", "event"), event.dump()},
          {topic("button", "acknowledge"), button.dump()}};
}

}  // namespace fallen
