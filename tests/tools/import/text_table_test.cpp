// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/text_table.hpp"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/import/input_error.hpp"

namespace fallen {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<TableRow> Read(const std::string& text) {
  const TemporaryFolder folder;
  return ReadTimedTable(folder.Write("depth.txt", text), "timestamp filename", 1);
}

std::string ErrorOf(const std::string& text) {
  try {
    Read(text);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("depth.txt"));
  }
  return "no error";
}

TEST(ReadTimedTable, SkipsCommentsAndBlankLinesAndKeepsLineNumbers) {
  const std::vector<TableRow> rows = Read("# timestamp filename\n\n 0.5 a.png \n\t\n1 b.png");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].line, 3);
  EXPECT_EQ(rows[0].utime, 500000);
  EXPECT_THAT(rows[0].fields, ElementsAre("a.png"));
  EXPECT_EQ(rows[1].line, 5);
  EXPECT_EQ(rows[1].utime, 1000000);
}

TEST(ReadTimedTable, TakesWindowsLineEnds) {
  EXPECT_THAT(Read("0 a.png\r\n1 b.png\r\n")[1].fields, ElementsAre("b.png"));
}

TEST(ReadTimedTable, KeepsMicrosecondsOfUnixTime) {
  EXPECT_EQ(Read("1305031102.175304 a.png")[0].utime, 1305031102175304);
}

TEST(ReadTimedTable, AnEmptyTableHasNoRows) { EXPECT_THAT(Read(""), IsEmpty()); }

TEST(ReadTimedTable, NamesFileLineGotAndExpected) {
  EXPECT_EQ(ErrorOf("0 a.png\n1\n"), "depth.txt:2: got \"1\", expected \"timestamp filename\"");
  EXPECT_THAT(ErrorOf("0 a.png b.png\n"), HasSubstr("depth.txt:1: got \"0 a.png b.png\""));
  for (const char* time : {"x", "nan", "inf", "-1", "1e300", "0x10", "1,5"})
    EXPECT_THAT(ErrorOf(std::string("#\n") + time + " a.png\n"),
                HasSubstr(std::string("depth.txt:2: got timestamp \"") + time + "\""));
}

TEST(ReadTimedTable, RefusesTimesThatDoNotAscend) {
  EXPECT_EQ(ErrorOf("1 a.png\n0.5 b.png\n"),
            "depth.txt:2: got timestamp 0.5, expected a later one than in line 1");
  EXPECT_THAT(ErrorOf("1 a.png\n1.0000001 b.png\n"), HasSubstr("depth.txt:2")) << "the same us";
}

TEST(ReadTimedTable, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(ReadTimedTable(folder.path() / "depth.txt", "row", 1), InputError);
  EXPECT_THROW(ReadTimedTable(folder.path(), "row", 1), InputError);
}

TEST(NumberField, TakesFiniteNumbersOnly) {
  TableRow row{7, 0, {"-1.5e-3", "+2", "nan", "1.5m"}};
  EXPECT_EQ(NumberField("f", row, 0, "tx"), -1.5e-3);
  EXPECT_EQ(NumberField("f", row, 1, "ty"), 2);
  for (const std::size_t index : {2, 3}) {
    try {
      NumberField("f", row, index, "tz");
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("f:7: got tz"));
      EXPECT_THAT(error.what(), EndsWith("expected a finite number"));
    }
  }
}

}  // namespace
}  // namespace fallen
