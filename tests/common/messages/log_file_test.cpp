// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/log_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcm/lcm.h>

#include <fstream>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::HasSubstr;

class LogFile : public testing::Test {
 protected:
  LogFile() {
    path_ = std::filesystem::path(testing::TempDir()) /
            (std::string("log_file_test_") +
             testing::UnitTest::GetInstance()->current_test_info()->name() + ".lcm");
  }
  ~LogFile() override { std::filesystem::remove(path_); }

  // Events of a few hundred bytes; event i holds i in every byte.
  static Bytes Payload(int i) { return Bytes(100 + 10 * (i % 7), static_cast<std::uint8_t>(i)); }

  void WriteEvents(int count) {
    LogWriter writer(path_);
    for (int i = 0; i < count; ++i)
      writer.Write(1000 + i, "CHANNEL_" + std::to_string(i % 3), Payload(i));
    writer.Close();
  }

  Bytes Content() const {
    std::ifstream file(path_, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
  }
  void SetContent(const Bytes& bytes) const {
    std::ofstream file(path_, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  // Offset at which event `i` of WriteEvents starts.
  static std::size_t Offset(int i) {
    std::size_t offset = 0;
    for (int k = 0; k < i; ++k) offset += 28 + 9 + Payload(k).size();
    return offset;
  }

  struct Result {
    std::vector<std::int64_t> numbers;
    std::vector<LogDamage> damage;
  };
  // Reads all, and checks that every event is one that was written, whole.
  Result Read() const {
    LogReader reader(path_);
    Result result;
    while (const auto event = reader.Next()) {
      const int i = static_cast<int>(event->number);
      EXPECT_EQ(event->data, Payload(i));
      EXPECT_EQ(event->channel, "CHANNEL_" + std::to_string(i % 3));
      EXPECT_EQ(event->utime, 1000 + i);
      result.numbers.push_back(event->number);
    }
    EXPECT_EQ(reader.position_bytes(), reader.size_bytes());
    result.damage = reader.damage();
    return result;
  }
  static std::vector<std::int64_t> AllBut(int count, std::vector<int> missing) {
    std::vector<std::int64_t> numbers;
    for (int i = 0; i < count; ++i)
      if (std::find(missing.begin(), missing.end(), i) == missing.end()) numbers.push_back(i);
    return numbers;
  }

  std::filesystem::path path_;
};

TEST_F(LogFile, ReadsBackWhatWasWritten) {
  WriteEvents(50);
  const Result result = Read();
  EXPECT_EQ(result.numbers, AllBut(50, {}));
  EXPECT_TRUE(result.damage.empty());
}

TEST_F(LogFile, AnEmptyLogHasNoEventsAndNoDamage) {
  WriteEvents(0);
  const Result result = Read();
  EXPECT_TRUE(result.numbers.empty());
  EXPECT_TRUE(result.damage.empty());
}

TEST_F(LogFile, LcmReadsWhatWeWrite) {
  WriteEvents(20);
  lcm_eventlog_t* const log = lcm_eventlog_create(path_.c_str(), "r");
  ASSERT_NE(log, nullptr);
  for (int i = 0; i < 20; ++i) {
    lcm_eventlog_event_t* const event = lcm_eventlog_read_next_event(log);
    ASSERT_NE(event, nullptr);
    EXPECT_EQ(event->eventnum, i);
    EXPECT_EQ(event->timestamp, 1000 + i);
    EXPECT_EQ(std::string(event->channel, event->channellen), "CHANNEL_" + std::to_string(i % 3));
    const auto* const data = static_cast<const std::uint8_t*>(event->data);
    EXPECT_EQ(Bytes(data, data + event->datalen), Payload(i));
    lcm_eventlog_free_event(event);
  }
  EXPECT_EQ(lcm_eventlog_read_next_event(log), nullptr);
  lcm_eventlog_destroy(log);
}

TEST_F(LogFile, WeReadWhatLcmWrites) {
  lcm_eventlog_t* const log = lcm_eventlog_create(path_.c_str(), "w");
  ASSERT_NE(log, nullptr);
  for (int i = 0; i < 20; ++i) {
    std::string channel = "CHANNEL_" + std::to_string(i % 3);
    Bytes data = Payload(i);
    lcm_eventlog_event_t event{};
    event.timestamp = 1000 + i;
    event.channellen = static_cast<std::int32_t>(channel.size());
    event.channel = channel.data();
    event.datalen = static_cast<std::int32_t>(data.size());
    event.data = data.data();
    ASSERT_EQ(lcm_eventlog_write_event(log, &event), 0);
  }
  lcm_eventlog_destroy(log);
  const Bytes theirs = Content();
  EXPECT_EQ(Read().numbers, AllBut(20, {}));
  WriteEvents(20);
  EXPECT_EQ(Content(), theirs) << "byte for byte";
}

TEST_F(LogFile, GarbageBetweenEventsCostsNoEvent) {
  WriteEvents(20);
  Bytes bytes = Content();
  const Bytes garbage(333, 0xAB);
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(Offset(7)), garbage.begin(),
               garbage.end());
  SetContent(bytes);
  const Result result = Read();
  EXPECT_EQ(result.numbers, AllBut(20, {}));
  ASSERT_EQ(result.damage.size(), 1u);
  EXPECT_EQ(result.damage[0].offset, static_cast<std::int64_t>(Offset(7)));
  EXPECT_EQ(result.damage[0].skipped_bytes, 333);
  EXPECT_THAT(result.damage[0].reason, HasSubstr("sync word"));
}

TEST_F(LogFile, GarbageAtTheStartCostsNoEvent) {
  WriteEvents(5);
  Bytes bytes = Content();
  bytes.insert(bytes.begin(), {0xED, 0xA1, 0xDA, 0x01, 1, 2, 3});
  SetContent(bytes);
  const Result result = Read();
  EXPECT_EQ(result.numbers, AllBut(5, {}));
  ASSERT_EQ(result.damage.size(), 1u);
  EXPECT_EQ(result.damage[0].offset, 0);
  EXPECT_EQ(result.damage[0].skipped_bytes, 7);
}

TEST_F(LogFile, ABrokenHeaderCostsItsEventOnly) {
  WriteEvents(20);
  const Bytes whole = Content();
  for (const int byte : {0, 3, 20, 21, 22, 24, 25}) {
    Bytes bytes = whole;
    bytes[Offset(7) + byte] ^= 0xFF;
    SetContent(bytes);
    const Result result = Read();
    EXPECT_EQ(result.numbers, AllBut(20, {7})) << byte;
    ASSERT_EQ(result.damage.size(), 1u) << byte;
    EXPECT_EQ(result.damage[0].offset, static_cast<std::int64_t>(Offset(7)));
    EXPECT_EQ(result.damage[0].skipped_bytes, static_cast<std::int64_t>(Offset(8) - Offset(7)));
  }
}

TEST_F(LogFile, ALengthThatReachesIntoLaterEventsCostsItsEventOnly) {
  WriteEvents(20);
  Bytes bytes = Content();
  bytes[Offset(7) + 26] = 2;  // 512 bytes and more: ends amid another event
  SetContent(bytes);
  const Result result = Read();
  EXPECT_EQ(result.numbers, AllBut(20, {7}));
  ASSERT_EQ(result.damage.size(), 1u);
  EXPECT_THAT(result.damage[0].reason, HasSubstr("next event"));
}

TEST_F(LogFile, BytesThatAreMissingCostTheirEventOnly) {
  WriteEvents(20);
  Bytes bytes = Content();
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(Offset(7) + 60);
  bytes.erase(begin, begin + 17);
  SetContent(bytes);
  const Result result = Read();
  EXPECT_EQ(result.numbers, AllBut(20, {7}));
  EXPECT_EQ(result.damage.size(), 1u);
}

TEST_F(LogFile, TruncatedAtAnyByteOfTheLastEventGivesTheOthers) {
  WriteEvents(5);
  const Bytes whole = Content();
  for (std::size_t size = Offset(4) + 1; size < whole.size(); ++size) {
    SetContent(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    const Result result = Read();
    EXPECT_EQ(result.numbers, AllBut(5, {4})) << size;
    ASSERT_EQ(result.damage.size(), 1u) << size;
    EXPECT_EQ(result.damage[0].offset, static_cast<std::int64_t>(Offset(4)));
    EXPECT_EQ(result.damage[0].skipped_bytes, static_cast<std::int64_t>(size - Offset(4)));
    EXPECT_THAT(result.damage[0].reason, HasSubstr("truncated"));
  }
}

TEST_F(LogFile, SyncWordsInsidePayloadsDoNotFoolTheReader) {
  // A payload full of sync words with lengths that look sane, in an event whose header is then
  // broken.
  const Bytes fake = {0xED, 0xA1, 0xDA, 0x01, 0, 0, 0, 0, 0, 0, 0,   9,   0,   0,   0, 0, 0, 0,
                      0,    9,    0,    0,    0, 4, 0, 0, 0, 8, 'F', 'A', 'K', 'E', 1, 2, 3};
  Bytes payload;
  for (int i = 0; i < 20; ++i) payload.insert(payload.end(), fake.begin(), fake.end());
  {
    LogWriter writer(path_);
    for (int i = 0; i < 3; ++i) writer.Write(i, "REAL", payload);
    writer.Close();
  }
  const Bytes whole = Content();
  Bytes bytes = whole;
  bytes[whole.size() / 3] = 0;  // the second event's sync word
  SetContent(bytes);
  LogReader reader(path_);
  std::vector<std::int64_t> numbers;
  while (const auto event = reader.Next()) {
    EXPECT_EQ(event->channel, "REAL");
    EXPECT_EQ(event->data, payload);
    numbers.push_back(event->number);
  }
  EXPECT_THAT(numbers, testing::ElementsAre(0, 2));
  ASSERT_EQ(reader.damage().size(), 1u);
  EXPECT_EQ(reader.damage()[0].skipped_bytes, static_cast<std::int64_t>(whole.size() / 3));
}

TEST_F(LogFile, AFileThatIsNoLogIsAllDamage) {
  std::mt19937 random(1);
  Bytes bytes(3'000'000);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  SetContent(bytes);
  const Result result = Read();
  EXPECT_TRUE(result.numbers.empty());
  ASSERT_EQ(result.damage.size(), 1u);
  EXPECT_EQ(result.damage[0].skipped_bytes, 3'000'000);
}

TEST_F(LogFile, RandomDamageNeverBreaksTheReader) {
  WriteEvents(200);
  const Bytes whole = Content();
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    Bytes bytes = whole;
    for (int k = 0; k < 20; ++k)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (round % 2 == 0) bytes.resize(random() % bytes.size());
    SetContent(bytes);
    LogReader reader(path_);
    std::int64_t events = 0;
    std::int64_t accounted = 0;
    while (const auto event = reader.Next()) {
      ++events;
      accounted += 28 + static_cast<std::int64_t>(event->channel.size() + event->data.size());
    }
    for (const LogDamage& damage : reader.damage()) accounted += damage.skipped_bytes;
    EXPECT_EQ(accounted, static_cast<std::int64_t>(bytes.size()))
        << "every byte is an event's or damage";
    EXPECT_GE(events, round % 2 == 0 ? 0 : 180);
  }
}

TEST_F(LogFile, EventsLargerThanTheReadersBuffer) {
  const Bytes large(5'000'000, 7);
  {
    LogWriter writer(path_);
    writer.Write(1, "SMALL", {1});
    writer.Write(2, "LARGE", large);
    writer.Write(3, "EMPTY", {});
    writer.Close();
  }
  LogReader reader(path_);
  EXPECT_EQ(reader.Next()->data, Bytes{1});
  EXPECT_EQ(reader.Next()->data, large);
  EXPECT_EQ(reader.Next()->data, Bytes{});
  EXPECT_FALSE(reader.Next());
  EXPECT_TRUE(reader.damage().empty());
}

TEST_F(LogFile, OpeningWhatIsNotThereSaysSo) {
  try {
    LogReader reader("/nowhere/a.lcm");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/a.lcm: cannot open: No such file"));
  }
  EXPECT_THROW(LogReader{testing::TempDir()}, std::runtime_error);
  EXPECT_THROW(LogWriter{"/nowhere/a.lcm"}, std::runtime_error);
}

TEST_F(LogFile, WritingToAFullDiskSaysSo) {
  LogWriter writer("/dev/full");
  const auto write = [&] {
    writer.Write(1, "A", Bytes(100000));
    writer.Close();
  };
  EXPECT_THROW(write(), std::runtime_error);
}

TEST_F(LogFile, ChannelNamesAreChecked) {
  LogWriter writer(path_);
  EXPECT_THROW(writer.Write(1, "", {}), std::invalid_argument);
  EXPECT_THROW(writer.Write(1, std::string(64, 'A'), {}), std::invalid_argument);
  writer.Write(1, std::string(63, 'A'), {});
}

}  // namespace
}  // namespace fallen
