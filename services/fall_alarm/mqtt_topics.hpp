// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "fallen/service/alarm_output_config.hpp"

namespace fallen {

/// Topics of one robot: <topic>/<robot>/...
struct MqttTopics {
  MqttTopics(const std::string& topic, const std::string& robot);

  std::string availability;  ///< retained "online" or, by the last will, "offline"
  std::string alarm;         ///< retained "ON" while an alarm is active, else "OFF"
  std::string alarms;        ///< retained: ActiveAlarmsJson
  std::string event;         ///< each change: AlarmJson; the newest is retained
  std::string acknowledge;   ///< command: an event id, "all", or {"event_id": ..., "by": ...}
  std::string close;         ///< the same, to close alarms
};

/// A message to be sent once.
struct MqttMessage {
  std::string topic;
  std::string payload;
};

/// What Home Assistant's MQTT discovery wants to know, one message an entity: the alarm as a binary
/// sensor of class safety, its changes as an event, acknowledging as a button.
/// https://www.home-assistant.io/integrations/mqtt/#mqtt-discovery
/// @param prefix  Home Assistant's discovery prefix; empty: no messages.
std::vector<MqttMessage> HomeAssistantDiscovery(const std::string& prefix, const std::string& robot,
                                                const MqttTopics& topics);

}  // namespace fallen
