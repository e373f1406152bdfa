// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-alarm beside a mosquitto with TLS and password that dies and comes back.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "services/fall_alarm/sqlite_database.hpp"
#include "tests/integration/alarm_fixture.hpp"
#include "tests/integration/mosquitto_broker.hpp"
#include "tests/support/run_program.hpp"

namespace fallen::testing_support {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::SizeIs;

class AlarmWithBroker : public Alarm {
 protected:
  void SetUp() override {
    if (!MosquittoBroker::IsInstalled()) GTEST_SKIP() << "mosquitto or openssl is not there";
    broker_.emplace(folder_ / "broker");
    listener_.emplace(*broker_, "listener",
                      std::vector<std::string>{"fallen/#", "homeassistant/#"});
  }
  bool Listen(const std::function<bool()>& done) {
    return listener_->ListenUntil(done, kAlarmTimeout);
  }
  void StartListening() {
    ASSERT_TRUE(Listen([&] { return listener_->is_subscribed(); }));
  }
  /// Changes that have come as events, "<event> <change>"; what came when the listener subscribed
  /// is left out.
  std::vector<std::string> Events() const {
    std::vector<std::string> events;
    for (const auto& message : listener_->messages()) {
      if (message.topic != "fallen/r2/event" || message.is_retained) continue;
      const json event = json::parse(message.payload);
      events.push_back(event.at("event_id").get<std::string>() + " " +
                       event.at("event_type").get<std::string>());
    }
    return events;
  }
  bool WaitForEvents(std::size_t count) {
    return Listen([&] { return Events().size() >= count; });
  }
  std::string Available() const { return listener_->Newest("fallen/r2/availability"); }
  bool WaitUntilAvailable() {
    return Listen([&] { return Available() == "online"; });
  }
  /// mosquitto_pub's part: not retained.
  void Command(const std::string& topic, const std::string& payload) {
    const MqttConfig config = broker_->Config();
    const ProgramOutcome outcome =
        RunCommand({"mosquitto_pub", "-h", config.host, "-p", std::to_string(config.port),
                    "--cafile", config.ca_file, "-u", config.username, "-P", "secret", "-q", "1",
                    "-t", topic, "-m", payload});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  std::optional<MosquittoBroker> broker_;
  std::optional<MqttListener> listener_;
};

TEST_F(AlarmWithBroker, TellsEverythingInOrder) {
  broker_->Start();
  StartListening();
  StartAlarm(broker_->Yaml());
  ASSERT_TRUE(WaitUntilAvailable());
  EXPECT_TRUE(Listen([&] { return listener_->Newest("fallen/r2/alarm") == "OFF"; }));
  const json sensor =
      json::parse(listener_->Newest("homeassistant/binary_sensor/fallen_r2/alarm/config"));
  EXPECT_EQ(sensor.at("state_topic"), "fallen/r2/alarm");

  Show(30, {kPerson});
  ASSERT_TRUE(WaitForEvents(1));
  EXPECT_TRUE(Listen([&] { return listener_->Newest("fallen/r2/alarm") == "ON"; }));
  const json alarms = json::parse(listener_->Newest("fallen/r2/alarms"));
  EXPECT_EQ(alarms.at("active"), 1);
  const std::string id = alarms.at("alarms").at(0).at("event_id");
  Command("fallen/r2/acknowledge", "not this one");
  Command("fallen/r2/acknowledge", "{\"event_id\": 5}");
  Command("fallen/r2/acknowledge", "{\"event_id\": \"" + id + "\", \"by\": \"night shift\"}");
  ASSERT_TRUE(WaitForEvents(2));
  EXPECT_EQ(json::parse(listener_->Newest("fallen/r2/event")).at("acknowledged_by"), "night shift");
  Show(60, {});
  ASSERT_TRUE(WaitForEvents(3));
  EXPECT_TRUE(Listen([&] { return listener_->Newest("fallen/r2/alarm") == "OFF"; }));
  Show(30, {kOther});
  ASSERT_TRUE(WaitForEvents(4));
  Command("fallen/r2/close", "all");
  ASSERT_TRUE(WaitForEvents(5));
  listener_->ListenFor(milliseconds(500));
  ASSERT_THAT(Events(), SizeIs(5));
  EXPECT_EQ(Events()[0], id + " raised");
  EXPECT_EQ(Events()[1], id + " acknowledged");
  EXPECT_EQ(Events()[2], id + " cleared");
  EXPECT_THAT(Events()[3], HasSubstr(" raised"));
  EXPECT_THAT(Events()[4], HasSubstr(" cleared"));

  StopAlarm();
  EXPECT_TRUE(Listen([&] { return Available() == "offline"; })) << "it says goodbye";
}

TEST_F(AlarmWithBroker, TheLastWillTellsOfAKilledOne) {
  broker_->Start();
  StartListening();
  StartAlarm(broker_->Yaml());
  ASSERT_TRUE(WaitUntilAvailable());
  KillAlarm();
  EXPECT_TRUE(Listen([&] { return Available() == "offline"; }));
}

TEST_F(AlarmWithBroker, ABrokerThatDiesAndComesBackMissesNothingAndHearsNothingTwice) {
  broker_->Start();
  StartListening();
  StartAlarm(broker_->Yaml());
  ASSERT_TRUE(WaitUntilAvailable());
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForEvents(1));
  listener_->ListenFor(milliseconds(2500));  // until the broker has written its state

  broker_->Kill();
  EXPECT_TRUE(WaitForStatusText("mqtt: localhost:"));
  Show(30, {kPerson, kOther});
  ASSERT_TRUE(WaitForAlarms(2)) << "LCM does not wait for the broker";
  Show(60, {kOther});
  ASSERT_TRUE(WaitForAlarms(3));
  listener_->ListenFor(milliseconds(200));
  EXPECT_THAT(Events(), SizeIs(1));

  broker_->Start();
  ASSERT_TRUE(WaitForEvents(3)) << alarm_->StandardError();
  listener_->ListenFor(milliseconds(1500));
  EXPECT_EQ(Events(), AlarmsOnLcm());
  StopAlarm();
}

TEST_F(AlarmWithBroker, KilledBetweenRaisingAndTellingItIsToldOnceAfterwards) {
  StartAlarm(broker_->Yaml());  // no broker yet: nothing can be told
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForAlarms(1));
  KillAlarm();
  const auto raised = AlarmsOnLcm();

  broker_->Start();
  StartListening();
  recorder_.Clear();
  StartAlarm(broker_->Yaml());
  ASSERT_TRUE(WaitForEvents(1)) << alarm_->StandardError();
  EXPECT_EQ(Events(), raised);
  KillAlarm();
  StartAlarm(broker_->Yaml());
  ASSERT_TRUE(WaitUntilAvailable());
  listener_->ListenFor(milliseconds(1500));
  EXPECT_EQ(Events(), raised) << "once";
  StopAlarm();
}

TEST_F(AlarmWithBroker, KilledBetweenTellingAndNotingItTellsItOnce) {
  broker_->Start();
  StartListening();
  StartAlarm(broker_->Yaml());
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForEvents(1));
  listener_->ListenFor(milliseconds(300));
  KillAlarm();
  // As if it had died before it could note that the broker has it.
  SqliteDatabase(History()).Run("UPDATE outbox SET sent = 0");
  StartAlarm(broker_->Yaml());
  listener_->ListenFor(milliseconds(2500));
  EXPECT_THAT(Events(), SizeIs(1));
  StopAlarm();
}

TEST_F(AlarmWithBroker, WhatIsWrongWithTheBrokerIsSaidAndNothingIsLost) {
  const auto trouble = [&](const std::string& yaml, const std::string& expected) {
    SCOPED_TRACE(expected);
    StartAlarm(yaml);
    EXPECT_TRUE(WaitForStatusText(expected)) << recorder_.Status("alarm").text;
    EXPECT_EQ(recorder_.Status("alarm").text.find('\n'), std::string::npos);
    EXPECT_EQ(recorder_.Status("alarm").state, service_status_t::DEGRADED);
    StopAlarm();
  };
  trouble(broker_->Yaml(), "Connection refused");
  broker_->Start();
  std::string yaml = broker_->Yaml();
  std::ofstream(folder_ / "wrong") << "guess\n";
  trouble(yaml.substr(0, yaml.find("  password_file")) +
              "  password_file: " + (folder_ / "wrong").string() + "\n",
          "not authorised");
  const std::string stranger = broker_->MakeCertificate("stranger", "localhost").string();
  std::string untrusted = yaml;
  untrusted.replace(untrusted.find("broker-ca.crt"), 13, "stranger-ca.crt");
  trouble(untrusted, "certificate verify failed");
  // The right authority, but the certificate is for localhost.
  std::string other_host = yaml;
  other_host.replace(other_host.find("localhost"), 9, "127.0.0.1");
  trouble(other_host, "certificate verify failed");

  StartAlarm(other_host);
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForAlarms(1));
  StopAlarm();
  StartListening();
  StartAlarm(yaml);
  EXPECT_TRUE(WaitForEvents(1)) << "told once the broker is the right one";
  StopAlarm();
}

}  // namespace
}  // namespace fallen::testing_support
