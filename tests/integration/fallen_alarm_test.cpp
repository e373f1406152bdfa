// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// fallen-alarm as a process, without a broker.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fallen/messages/log_file.hpp"
#include "tests/integration/alarm_fixture.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/support/run_program.hpp"

namespace fallen::testing_support {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

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

// One process and two, from the same decisions: the same alarms.
TEST_F(Alarm, SaysWhatFallenDetectSaysOfTheDemoRecordingBitForBit) {
  const std::string log = (folder_ / "decided.lcm").string();
  const ProgramOutcome detected =
      RunProgram("fallen-detect", {FALLEN_SOURCE_DIR "/recordings/demo.lcm", "--alarms", "--json",
                                   "/dev/null", "--output", log});
  ASSERT_EQ(detected.status, 0) << detected.err;
  std::vector<std::vector<std::uint8_t>> expected;
  LogReader reader(log);
  while (const auto event = reader.Next())
    if (event->channel == "FALL_ALARM") expected.push_back(event->data);
  ASSERT_FALSE(expected.empty()) << "no alarm would agree too easily";
  StartAlarm("", "robot");
  ChildProcess player(
      {"lcm-logplayer", "--lcm-url=" + url_, "--speed=3", "--regexp=FALLEN_PERSONS_.*", log},
      folder_.path());
  ASSERT_TRUE(WaitForAlarms(expected.size()));
  recorder_.HandleFor(milliseconds(500));
  std::vector<std::vector<std::uint8_t>> told;  // without the repetitions
  for (const auto& message : recorder_.Bytes("FALL_ALARM"))
    if (std::find(told.begin(), told.end(), message) == told.end()) told.push_back(message);
  EXPECT_EQ(told, expected);
  StopAlarm();
}

}  // namespace
}  // namespace fallen::testing_support
