// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcm/lcm.h>

#include <nlohmann/json.hpp>

#include "message_samples.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/log_check/log_report.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

constexpr char kProgram[] = "fallen-log-check";

class LogCheck : public testing::Test {
 protected:
  static Bytes Image(std::int64_t seq) {
    StampedDepthImage image = samples::SampleDepthImage();
    image.header.seq = seq;
    return EncodeMessage(ToMessage(image));
  }

  // Ten images at 10 Hz but for number 4, ten poses, and a message of somebody else's.
  void WriteLog() const {
    LogWriter writer(log_);
    for (int i = 0; i < 10; ++i) {
      if (i != 4) writer.Write(1'000'000 + 100'000 * i, "DEPTH_FRONT", Image(i));
      writer.Write(1'000'001 + 100'000 * i, "ROBOT_POSE", EncodeMessage(samples::SamplePose()));
    }
    writer.Write(2'000'000, "OTHER", {0, 0, 0, 0, 0, 0, 0, 0xAB, 1});
    writer.Close();
  }

  // Breaks event 6 (a header byte), puts garbage before the end, and cuts the last event.
  void Damage() const {
    std::string content = ReadText(log_);
    std::size_t offset = 0;
    for (int i = 0; i < 6; ++i) offset = content.find("\xED\xA1\xDA\x01", offset + 1);
    content[offset + 20] = '\x7F';
    content.resize(content.size() - 4);
    folder_.Write("run.lcm", content);
  }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_.path() / "run.lcm";
  std::filesystem::path repaired_ = folder_.path() / "repaired.lcm";
};

TEST_F(LogCheck, ListsWhatACleanLogHolds) {
  WriteLog();
  const LogReport report = CheckLog(log_);
  EXPECT_TRUE(report.is_clean());
  EXPECT_EQ(report.events, 20);
  ASSERT_EQ(report.channels.size(), 3u);
  const ChannelReport& depth = report.channels.at("DEPTH_FRONT");
  EXPECT_EQ(depth.messages, 9);
  EXPECT_EQ(depth.missing, 1);
  EXPECT_EQ(depth.out_of_order, 0);
  EXPECT_EQ(depth.types, (std::map<std::string, std::int64_t>{{"depth_image_t", 9}}));
  EXPECT_DOUBLE_EQ(depth.span_s(), 0.9);
  EXPECT_NEAR(depth.rate_hz(), 8 / 0.9, 1e-9);
  EXPECT_EQ(report.channels.at("OTHER").types.count("unknown 0x00000000000000ab"), 1u);
  EXPECT_EQ(report.channels.at("OTHER").rate_hz(), 0);
}

TEST_F(LogCheck, CountsMessagesOutOfOrder) {
  LogWriter writer(log_);
  for (const int seq : {5, 6, 6, 3, 9}) writer.Write(1, "DEPTH_FRONT", Image(seq));
  writer.Close();
  const LogReport report = CheckLog(log_);
  EXPECT_EQ(report.channels.at("DEPTH_FRONT").out_of_order, 2);
  EXPECT_EQ(report.channels.at("DEPTH_FRONT").missing, 5);
}

TEST_F(LogCheck, TellsWhereTheLogIsDamaged) {
  WriteLog();
  Damage();
  const LogReport report = CheckLog(log_);
  EXPECT_FALSE(report.is_clean());
  ASSERT_EQ(report.damage.size(), 2u);
  EXPECT_THAT(report.damage[0].reason, HasSubstr("channel length"));
  EXPECT_THAT(report.damage[1].reason, HasSubstr("truncated"));
  EXPECT_EQ(report.events, 18);
}

TEST_F(LogCheck, ABadMessageIsToldWithItsOffset) {
  {
    LogWriter writer(log_);
    writer.Write(1, "DEPTH_FRONT", Image(0));
    Bytes bad = Image(1);
    bad.pop_back();
    writer.Write(2, "DEPTH_FRONT", bad);
    writer.Close();
  }
  const LogReport report = CheckLog(log_);
  EXPECT_TRUE(report.damage.empty());
  ASSERT_EQ(report.bad_messages(), 1);
  const BadMessage& bad = report.channels.at("DEPTH_FRONT").bad.front();
  EXPECT_EQ(bad.offset, static_cast<std::int64_t>(28 + 11 + Image(0).size()));
  EXPECT_THAT(bad.reason, HasSubstr("depth_image_t.data: got "));
}

TEST_F(LogCheck, TheProgramReportsAndExitsWith0ForACleanLog) {
  WriteLog();
  const ProgramOutcome outcome = RunProgram(kProgram, {log_.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("20 events on 3 channels; 0 damaged places (0 bytes), 0 bad messages"));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("DEPTH_FRONT +depth_image_t +9 +8.89 +0.90 .* 1 +0 +0\n"));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(LogCheck, TheProgramExitsWith1ForADamagedLog) {
  WriteLog();
  Damage();
  const ProgramOutcome outcome = RunProgram(kProgram, {log_.string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("2 damaged places"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex(
                               "damage at offset [0-9]+, [0-9]+ bytes: channel length: got "));
}

TEST_F(LogCheck, TheProgramReportsInJson) {
  WriteLog();
  Damage();
  const ProgramOutcome outcome = RunProgram(kProgram, {log_.string(), "--json"});
  EXPECT_EQ(outcome.status, 1);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["clean"], false);
  EXPECT_EQ(json["events"], 18);
  EXPECT_EQ(json["damage"].size(), 2u);
  EXPECT_EQ(json["channels"]["ROBOT_POSE"]["types"]["pose_t"],
            json["channels"]["ROBOT_POSE"]["messages"]);
}

TEST_F(LogCheck, ARepairedLogIsCleanAndLcmReadsItToTheEnd) {
  WriteLog();
  Damage();
  const ProgramOutcome outcome =
      RunProgram(kProgram, {log_.string(), "--repair", repaired_.string()});
  EXPECT_EQ(outcome.status, 1) << "the log itself is damaged still";
  const LogReport report = CheckLog(repaired_);
  EXPECT_TRUE(report.is_clean());
  EXPECT_EQ(report.events, 18);

  lcm_eventlog_t* const log = lcm_eventlog_create(repaired_.c_str(), "r");
  ASSERT_NE(log, nullptr);
  int events = 0;
  while (lcm_eventlog_event_t* const event = lcm_eventlog_read_next_event(log)) {
    lcm_eventlog_free_event(event);
    ++events;
  }
  lcm_eventlog_destroy(log);
  EXPECT_EQ(events, 18);
}

TEST_F(LogCheck, RepairingOverAFileIsRefused) {
  WriteLog();
  const std::string before = ReadText(log_);
  const ProgramOutcome outcome = RunProgram(kProgram, {log_.string(), "--repair", log_.string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("expected a new one"));
  EXPECT_TRUE(IsOneLine(outcome.err));
  EXPECT_EQ(ReadText(log_), before);
}

TEST_F(LogCheck, WrongCallsAreOneLineAndStatus2) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {}, {"/nowhere.lcm"}, {folder_.path().string()}, {"a.lcm", "--what"}}) {
    const ProgramOutcome outcome = RunProgram(kProgram, arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("fallen-log-check: "));
  }
  EXPECT_EQ(RunProgram(kProgram, {"--help"}).status, 0);
  EXPECT_EQ(RunProgram(kProgram, {"--version"}).status, 0);
}

TEST_F(LogCheck, AFileThatIsNoLogIsAllDamage) {
  folder_.Write("run.lcm", std::string(100'000, 'x'));
  const ProgramOutcome outcome = RunProgram(kProgram, {log_.string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("0 events on 0 channels; 1 damaged places (100000 bytes)"));
}

}  // namespace
}  // namespace fallen
