// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/mqtt_topics.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "services/fall_alarm/alarm_json.hpp"
#include "tests/services/fall_alarm/sample_alarms.hpp"

namespace fallen {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

const MqttTopics kTopics("fallen", "r2");

/// Fields that Home Assistant documents for each kind of entity, of those that we send.
/// https://www.home-assistant.io/integrations/{binary_sensor,event,button}.mqtt/
const std::set<std::string> kCommon = {"name",
                                       "unique_id",
                                       "availability_topic",
                                       "qos",
                                       "payload_available",
                                       "payload_not_available",
                                       "device",
                                       "origin"};
const std::map<std::string, std::set<std::string>> kOwn = {
    {"binary_sensor",
     {"device_class", "state_topic", "payload_on", "payload_off", "json_attributes_topic"}},
    {"event", {"state_topic", "event_types"}},
    {"button", {"command_topic", "payload_press"}}};

TEST(MqttTopics, AreOfOneRobot) {
  EXPECT_EQ(kTopics.alarm, "fallen/r2/alarm");
  EXPECT_EQ(kTopics.event, "fallen/r2/event");
  EXPECT_EQ(kTopics.availability, "fallen/r2/availability");
}

TEST(HomeAssistantDiscovery, SendsNothingButDocumentedFields) {
  std::set<std::string> components, unique_ids;
  for (const MqttMessage& message : HomeAssistantDiscovery("homeassistant", "r2", kTopics)) {
    SCOPED_TRACE(message.topic);
    // <prefix>/<component>/<node_id>/<object_id>/config
    EXPECT_THAT(message.topic, testing::MatchesRegex(
                                   "homeassistant/[a-z_]+/[a-zA-Z0-9_-]+/[a-zA-Z0-9_-]+/config"));
    const std::size_t begin = message.topic.find('/') + 1;
    const std::string component =
        message.topic.substr(begin, message.topic.find('/', begin) - begin);
    components.insert(component);
    const json payload = json::parse(message.payload);
    std::set<std::string> expected = kOwn.at(component);
    expected.insert(kCommon.begin(), kCommon.end());
    std::set<std::string> got;
    for (const auto& [key, value] : payload.items()) got.insert(key);
    EXPECT_EQ(got, expected);
    unique_ids.insert(payload.at("unique_id"));
    EXPECT_EQ(payload.at("availability_topic"), kTopics.availability);
    EXPECT_THAT(payload.at("device").at("identifiers"), ElementsAre("fallen_r2"));
    for (const auto& [key, value] : payload.at("device").items())
      EXPECT_TRUE(
          (std::set<std::string>{"identifiers", "name", "manufacturer", "model", "sw_version"}
               .contains(key)))
          << key;
    EXPECT_TRUE(payload.at("origin").contains("name")) << "the only one that is required";
  }
  EXPECT_THAT(components, ElementsAre("binary_sensor", "button", "event"));
  EXPECT_EQ(unique_ids.size(), 3U);
}

TEST(HomeAssistantDiscovery, PointsToWhatIsSent) {
  const auto entities = HomeAssistantDiscovery("ha", "r2", kTopics);
  const json alarm = json::parse(entities.at(0).payload);
  EXPECT_EQ(alarm.at("state_topic"), kTopics.alarm);
  EXPECT_EQ(alarm.at("device_class"), "safety") << "on means unsafe";
  const json event = json::parse(entities.at(1).payload);
  EXPECT_THAT(event.at("event_types"), ElementsAre("raised", "updated", "acknowledged", "cleared"));
  // What an event entity reads of the payload.
  EXPECT_EQ(AlarmJson({"r2", 1, testing_support::SampleFall("a", 0, AlarmChange::kRaised)})
                .at("event_type"),
            "raised");
  EXPECT_EQ(json::parse(entities.at(2).payload).at("payload_press"), "all");
}

TEST(HomeAssistantDiscovery, CanBeSwitchedOff) {
  EXPECT_THAT(HomeAssistantDiscovery("", "r2", kTopics), IsEmpty());
}

TEST(AlarmJson, SurvivesNamesThatAreNoUtf8) {
  FallAlarm alarm = testing_support::SampleFall("a", 0, AlarmChange::kAcknowledged);
  alarm.acknowledged_by = "nurse \xff\xfe";
  const std::string line = JsonLine(AlarmJson({"r2", 1, alarm}));
  EXPECT_EQ(json::parse(line).at("event_id"), "a");
}

}  // namespace
}  // namespace fallen
