// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-alarm as a process, beside a mosquitto with TLS and password that dies and comes back.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "fallen/fall_alarm_t.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "services/fall_alarm/sqlite_database.hpp"
#include "tests/integration/mosquitto_broker.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/seen_place.hpp"

namespace fallen::testing_support {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr seconds kTimeout{30};
constexpr std::int64_t kStart = 1'700'000'000'000'000;
const Eigen::Vector3d kPerson{2, 0, 0.15};
const Eigen::Vector3d kOther{2, 1.2, 0.15};

class Alarm : public testing::Test {
 protected:
  Alarm() : url_(EnterPrivateNetwork()), recorder_(url_) {}

  void StartAlarm(const std::string& yaml = "") {
    std::ofstream(folder_ / "alarm.yaml") << "service: {robot: r2}\n" << yaml;
    alarm_.emplace(
        std::vector<std::string>{Program("fallen-alarm"), "--lcm-url", url_, "--config",
                                 (folder_ / "alarm.yaml").string(), "--history", History()},
        folder_.path());
    const bool is_up = recorder_.HandleUntil(
        [&] { return recorder_.Status("alarm").pid == alarm_->pid(); }, kTimeout);
    ASSERT_TRUE(is_up) << alarm_->StandardError();
  }
  std::string History() const { return (folder_ / "alarms.db").string(); }

  /// Frames at 10 Hz of message time, as fast as they go, with persons at these places.
  void Show(int frames, const std::vector<Eigen::Vector3d>& persons) {
    for (int i = 0; i < frames; ++i, ++seq_) {
      Decision decision = seen_place::Empty(seen_place::LookAt({0, 0.5, 1}, {2, 0.5, 0.15}));
      for (const Eigen::Vector3d& person : persons) seen_place::AddCluster(decision, person, 0.99);
      const auto bytes =
          EncodeMessage(ToMessage(Header{kStart + 100'000 * seq_, seq_, "FRONT"}, decision));
      recorder_.lcm().publish("FALLEN_PERSONS_FRONT", bytes.data(),
                              static_cast<unsigned>(bytes.size()));
      recorder_.HandleFor(milliseconds(2));
    }
  }
  /// Different alarm messages so far: "<event> <change>", without repetitions.
  std::vector<std::string> AlarmsOnLcm() {
    std::vector<std::string> alarms;
    std::set<std::pair<std::string, int>> seen;
    for (const auto& alarm : recorder_.Messages<fall_alarm_t>("FALL_ALARM"))
      if (seen.emplace(alarm.event_id, alarm.revision).second)
        alarms.push_back(alarm.event_id + " " +
                         std::string(EnumName(static_cast<AlarmChange>(alarm.change))));
    return alarms;
  }
  bool WaitForAlarms(std::size_t count) {
    return recorder_.HandleUntil([&] { return AlarmsOnLcm().size() >= count; }, kTimeout);
  }
  void Answer(const std::string& event_id, bool closes = false) {
    const auto bytes =
        EncodeMessage(ToMessage(AlarmAnswer{kStart + 100'000 * seq_, event_id, "nurse", closes}));
    recorder_.lcm().publish("FALL_ALARM_ACK", bytes.data(), static_cast<unsigned>(bytes.size()));
  }
  void StopAlarm() {
    EXPECT_EQ(alarm_->Stop(), 0) << alarm_->StandardError();
    alarm_.reset();
  }
  void KillAlarm() {
    alarm_->Signal(SIGKILL);
    EXPECT_EQ(alarm_->WaitForExit(seconds(10)), 128 + SIGKILL);
    alarm_.reset();
  }
  bool WaitForStatusText(const std::string& part) {
    return recorder_.HandleUntil(
        [&] { return recorder_.Status("alarm").text.find(part) != std::string::npos; }, kTimeout);
  }

  const std::string url_;
  TemporaryFolder folder_;
  LcmRecorder recorder_;
  std::optional<ChildProcess> alarm_;
  std::int64_t seq_ = 0;
};

TEST_F(Alarm, RaisesAcknowledgesClearsAndRemembers) {
  StartAlarm();
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForAlarms(1));
  Answer("");
  ASSERT_TRUE(WaitForAlarms(2));
  Show(60, {});
  ASSERT_TRUE(WaitForAlarms(3));
  const std::string id = recorder_.Messages<fall_alarm_t>("FALL_ALARM")[0].event_id;
  EXPECT_THAT(AlarmsOnLcm(), ElementsAre(id + " raised", id + " acknowledged", id + " cleared"));
  EXPECT_THAT(id, StartsWith("r2-20231114T2213"));
  recorder_.HandleFor(milliseconds(1200));
  const service_status_t status = recorder_.Status("alarm");
  EXPECT_EQ(status.received, 90);
  EXPECT_EQ(status.published, 3);
  EXPECT_EQ(status.lost_upstream, 0);
  EXPECT_EQ(status.state, service_status_t::RUNNING) << status.text;
  EXPECT_LE(status.resident_bytes, kMaxResidentBytes);

  // The tool reads beside the running service.
  const std::vector<std::string> tool = {Program("fallen-alarm"), "history", "--file", History()};
  const auto call = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), tool.begin(), tool.end());
    return RunCommand(arguments);
  };
  EXPECT_THAT(call({"list"}).out, StartsWith(id + "  cleared"));
  EXPECT_EQ(json::parse(call({"list", "--json"}).out).at("acknowledged_by"), "nurse");
  EXPECT_EQ(call({"export", (folder_ / "out").string()}).status, 0);
  std::ifstream changes(folder_ / "out" / id / "changes.json");
  EXPECT_THAT(json::parse(changes), SizeIs(3));
  LogReader snapshot(folder_ / "out" / id / "snapshot-0.lcm");
  EXPECT_EQ(snapshot.Next()->channel, "FALLEN_PERSONS_FRONT");
  EXPECT_EQ(call({"export", (folder_ / "out").string(), "--event", "x"}).status, 2);
  EXPECT_EQ(call({"purge", "--older-than", "100000"}).out, "purged 0\n");
  EXPECT_EQ(call({"purge", "--older-than", "1"}).out, "purged 1\n");
  EXPECT_EQ(call({"list"}).out, "");
  StopAlarm();
}

TEST_F(Alarm, GoesOnWhereAKilledOneStopped) {
  StartAlarm();
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForAlarms(1));
  KillAlarm();
  recorder_.Clear();
  StartAlarm();
  ASSERT_TRUE(WaitForAlarms(1)) << "repeated without any frame";
  Show(30, {kPerson});
  recorder_.HandleFor(milliseconds(300));
  EXPECT_THAT(AlarmsOnLcm(), SizeIs(1)) << "the same person is the same alarm";
  StopAlarm();
}

TEST_F(Alarm, ADamagedHistoryIsOneLineAndTheServiceIsUp) {
  std::ofstream(History()) << std::string(10000, '#');
  StartAlarm();
  EXPECT_TRUE(WaitForStatusText("file is not a database: set aside as alarms.db.damaged-1"));
  Show(30, {kPerson});
  EXPECT_TRUE(WaitForAlarms(1));
  StopAlarm();
}

TEST_F(Alarm, WrongCallsAndFilesAreOneLine) {
  const auto complaint = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {Program("fallen-alarm")};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProgramOutcome outcome = RunCommand(command, seconds(20));
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    const std::string& line = outcome.err;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
    return line;
  };
  const auto with = [&](const std::string& yaml) {
    std::ofstream(folder_ / "wrong.yaml") << yaml;
    return complaint({"--config", (folder_ / "wrong.yaml").string(), "--history", History()});
  };
  std::ofstream(folder_ / "zones.yaml")
      << "zones:\n  - {name: bed, kind: bed, corners: [[0, 0], [2, 2], [2, 0], [0, 2]]}\n";
  EXPECT_THAT(with("files: {zones: zones.yaml}\n"),
              HasSubstr("zones.yaml:2: zone 'bed': the edges after corners 1 and 3 cross"));
  EXPECT_THAT(with("alarm: {raise_log_odds: -5}\n"), HasSubstr("wrong.yaml:1: alarm: "));
  EXPECT_THAT(with("mqtt: {host: localhost, ca_file: nowhere.crt}\n"), HasSubstr("nowhere.crt"));
  EXPECT_THAT(with("mqtt: {host: h, username: u, password_file: nowhere}\n"),
              HasSubstr("nowhere: cannot be read"));
  EXPECT_THAT(complaint({"history", "list", "--file", "/nowhere.db"}),
              HasSubstr("/nowhere.db: no such file"));
  std::ofstream(folder_ / "damaged.db") << std::string(10000, '#');
  EXPECT_THAT(complaint({"history", "list", "--file", (folder_ / "damaged.db").string()}),
              HasSubstr("damaged.db: file is not a database"));
  StartAlarm();
  EXPECT_THAT(complaint({"--lcm-url", url_, "--history", History()}),
              HasSubstr("in use by another fallen-alarm"));
  StopAlarm();
}

TEST_F(Alarm, OthersHearItWithTheMessageTypesAlone) {
  if (RunCommand({"python3", "--version"}).status != 0) GTEST_SKIP() << "python3 is not there";
  ChildProcess subscriber({Program("alarm_subscriber"), url_}, folder_.path());
  const std::string log = (folder_ / "heard.lcm").string();
  ChildProcess logger({"lcm-logger", "-q", "-f", "--lcm-url=" + url_, log}, folder_.path());
  StartAlarm();
  recorder_.HandleFor(milliseconds(500));  // no late joining
  Show(30, {kPerson});
  ASSERT_TRUE(WaitForAlarms(1));
  Answer("", true);
  ASSERT_TRUE(WaitForAlarms(2));
  EXPECT_EQ(subscriber.WaitForExit(seconds(10)), 0);
  const std::string id = recorder_.Messages<fall_alarm_t>("FALL_ALARM")[0].event_id;
  EXPECT_THAT(subscriber.StandardOutput(),
              AllOf(StartsWith(id + " raised at 2.00 0.00 m"), HasSubstr("\n" + id + " cleared ")));
  recorder_.HandleFor(milliseconds(1200));
  EXPECT_EQ(logger.Stop(), 0);
  const ProgramOutcome decoded =
      RunShell("PYTHONPATH='" FALLEN_PYTHON_DIR "' python3 '" + std::string(FALLEN_SOURCE_DIR) +
               "/examples/decode_log.py' '" + log + "'");
  EXPECT_EQ(decoded.status, 0) << decoded.err;
  EXPECT_THAT(decoded.out, AllOf(HasSubstr("FALL_ALARM " + id + " 0 0 2.00 0.00 0.15\n"),
                                 HasSubstr("FALL_ALARM " + id + " 1 3 2.00 0.00 0.15\n"),
                                 HasSubstr("FALLEN_PERSONS_FRONT 29 1 32\n")));
  StopAlarm();
}

class AlarmWithBroker : public Alarm {
 protected:
  void SetUp() override {
    if (!MosquittoBroker::IsInstalled()) GTEST_SKIP() << "mosquitto or openssl is not there";
    broker_.emplace(folder_ / "broker");
    listener_.emplace(*broker_, "listener",
                      std::vector<std::string>{"fallen/#", "homeassistant/#"});
  }
  bool Listen(const std::function<bool()>& done) { return listener_->ListenUntil(done, kTimeout); }
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
