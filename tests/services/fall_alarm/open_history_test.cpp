// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/open_history.hpp"

#include <gmock/gmock.h>

#include "tests/services/fall_alarm/sample_alarms.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing_support::SampleFall;

class OpenHistory : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "alarms.db";
};

TEST_F(OpenHistory, AGoodFileIsOpenedAsItIs) {
  AlarmHistory(file_).Record("r", SampleFall("a", 0, AlarmChange::kRaised));
  const OpenedHistory opened = OpenHistoryAnyhow(file_);
  EXPECT_EQ(opened.note, "");
  EXPECT_THAT(opened.history->Falls(), SizeIs(1));
}

TEST_F(OpenHistory, ADamagedFileIsSetAsideAndSaidInOneLine) {
  folder_.Write("alarms.db", std::string(5000, 'x'));
  const OpenedHistory opened = OpenHistoryAnyhow(file_);
  EXPECT_THAT(opened.note, HasSubstr(file_.string() + ": file is not a database: set aside as "
                                                      "alarms.db.damaged-1, a new history"));
  EXPECT_THAT(opened.note, Not(HasSubstr("\n")));
  EXPECT_EQ(ReadText(folder_.path() / "alarms.db.damaged-1"), std::string(5000, 'x'));
  EXPECT_EQ(opened.history->Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
}

TEST_F(OpenHistory, DamageInTheMiddleIsFound) {
  {
    AlarmHistory history(file_);
    for (int i = 0; i < 200; ++i)
      history.Record("r", SampleFall("a" + std::to_string(i), 0, AlarmChange::kRaised));
  }
  std::string bytes = ReadText(file_);
  ASSERT_GT(bytes.size(), 20000U);
  for (std::size_t i = 9000; i < 13000; ++i) bytes[i] = static_cast<char>(i * 37);
  folder_.Write("alarms.db", bytes);
  EXPECT_THAT(OpenHistoryAnyhow(file_).note, HasSubstr("set aside as alarms.db.damaged-1"));
}

TEST_F(OpenHistory, WhatIsNoHistoryIsLeftAlone) {
  {
    const SqliteDatabase other(file_);
    other.Run("CREATE TABLE recipes (name TEXT)");
  }
  const OpenedHistory opened = OpenHistoryAnyhow(file_);
  EXPECT_THAT(opened.note, HasSubstr("got a database of something else, expected a history"));
  EXPECT_THAT(opened.note, HasSubstr("only in memory"));
  EXPECT_EQ(opened.history->Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
  EXPECT_EQ(SqliteDatabase(file_).Number("SELECT count(*) FROM recipes"), 0);
}

TEST_F(OpenHistory, ANewerVersionIsLeftAlone) {
  AlarmHistory(file_).Record("r", SampleFall("a", 0, AlarmChange::kRaised));
  SqliteDatabase(file_).Run("PRAGMA user_version = 9");
  EXPECT_THAT(OpenHistoryAnyhow(file_).note, HasSubstr("version: got 9, expected 1"));
  EXPECT_EQ(SqliteDatabase(file_).Number("SELECT count(*) FROM changes"), 1);
}

TEST_F(OpenHistory, WhereNothingCanBeWrittenItIsInMemory) {
  const OpenedHistory opened = OpenHistoryAnyhow("/proc/nowhere/alarms.db");
  EXPECT_THAT(opened.note, HasSubstr("only in memory"));
  EXPECT_EQ(opened.history->Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
}

TEST_F(OpenHistory, OneProcessAtATime) {
  const HistoryLock first(file_);
  try {
    const HistoryLock second(file_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), file_.string() + ": in use by another fallen-alarm");
  }
}

}  // namespace
}  // namespace fallen
