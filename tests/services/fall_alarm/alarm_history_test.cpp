// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/alarm_history.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "tests/services/fall_alarm/sample_alarms.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing_support::kRaisedUtime;
using testing_support::SampleFall;

class AlarmHistoryTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "new" / "alarms.db";
};

std::vector<std::string> Ids(const std::vector<NumberedAlarm>& alarms) {
  std::vector<std::string> ids;
  for (const NumberedAlarm& alarm : alarms) ids.push_back(alarm.alarm.id);
  return ids;
}

TEST_F(AlarmHistoryTest, KeepsWhatHappenedInOrder) {
  {
    AlarmHistory history(file_);
    EXPECT_EQ(history.NextNumber(), 1);
    EXPECT_THAT(history.Falls(), IsEmpty());
    EXPECT_EQ(history.Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
    EXPECT_EQ(history.Record("r", SampleFall("b", 0, AlarmChange::kRaised)), 2);
    EXPECT_EQ(history.Record("r", SampleFall("a", 1, AlarmChange::kCleared)), 3);
  }
  const AlarmHistory history(file_);
  EXPECT_EQ(history.NextNumber(), 4);
  EXPECT_THAT(Ids(history.Falls()), ElementsAre("b", "a"));
  EXPECT_THAT(Ids(history.Active()), ElementsAre("b"));
  const auto changes = history.Changes("a");
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_EQ(changes[0], (NumberedAlarm{"r", 1, SampleFall("a", 0, AlarmChange::kRaised)}));
  EXPECT_EQ(changes[1], (NumberedAlarm{"r", 3, SampleFall("a", 1, AlarmChange::kCleared)}));
  EXPECT_THAT(history.Changes("c"), IsEmpty());
}

TEST_F(AlarmHistoryTest, TheSameChangeIsThereOnce) {
  AlarmHistory history(file_);
  EXPECT_EQ(history.Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
  EXPECT_EQ(history.Record("r", SampleFall("a", 0, AlarmChange::kRaised)), 1);
  EXPECT_THAT(history.Changes("a"), SizeIs(1));
  EXPECT_EQ(history.NextNumber(), 2);
}

TEST_F(AlarmHistoryTest, TheOutboxHandsOutInOrderUntilSent) {
  AlarmHistory history(file_);
  EXPECT_FALSE(history.FirstUnsent());
  history.Record("r", SampleFall("a", 0, AlarmChange::kRaised));
  history.Record("r", SampleFall("a", 1, AlarmChange::kUpdated));
  EXPECT_EQ(history.FirstUnsent()->number, 1);
  EXPECT_EQ(history.FirstUnsent()->number, 1) << "asking is not sending";
  history.MarkSent(1);
  EXPECT_EQ(history.FirstUnsent()->number, 2);
  history.MarkSent(2);
  history.MarkSent(1);
  EXPECT_FALSE(history.FirstUnsent()) << "never back";
  const AlarmHistory again(file_);
  EXPECT_FALSE(again.FirstUnsent());
}

TEST_F(AlarmHistoryTest, KeepsTheFirstAndTheNewestSnapshot) {
  AlarmHistory history(file_);
  for (int i = 0; i < 5; ++i)
    history.Record("r", SampleFall("a", i, i == 0 ? AlarmChange::kRaised : AlarmChange::kUpdated),
                   AlarmSnapshot{100 + i, {std::uint8_t(i), 7}});
  const auto snapshots = history.Snapshots("a");
  ASSERT_THAT(snapshots, SizeIs(2));
  EXPECT_EQ(snapshots[0].utime, 100);
  EXPECT_EQ(snapshots[1].utime, 104);
  EXPECT_THAT(snapshots[1].log, ElementsAre(4, 7));
}

TEST_F(AlarmHistoryTest, PurgesWhatIsOverAndTold) {
  AlarmHistory history(file_);
  history.Record("r", SampleFall("old", 0, AlarmChange::kRaised), AlarmSnapshot{1, {1}});
  history.Record("r", SampleFall("old", 1, AlarmChange::kCleared));
  history.Record("r", SampleFall("active", 0, AlarmChange::kRaised));
  history.MarkSent(3);
  history.Record("r", SampleFall("untold", 0, AlarmChange::kRaised));
  history.Record("r", SampleFall("untold", 1, AlarmChange::kCleared));
  EXPECT_EQ(history.Purge(kRaisedUtime), 0) << "younger";
  EXPECT_EQ(history.Purge(kRaisedUtime + 10'000'000), 1);
  EXPECT_THAT(Ids(history.Falls()), ElementsAre("active", "untold"));
  EXPECT_THAT(history.Snapshots("old"), IsEmpty());
  EXPECT_EQ(history.NextNumber(), 6) << "no number comes twice";
}

TEST_F(AlarmHistoryTest, ADyingProcessTakesNothingBackThatWasRecorded) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    AlarmHistory history(file_);
    for (int i = 0;; ++i) {
      const std::int64_t number =
          history.Record("r", SampleFall("a" + std::to_string(i), 0, AlarmChange::kRaised));
      if (write(pipe_ends[1], &number, sizeof number) < 0) _exit(1);
    }
  }
  close(pipe_ends[1]);
  std::int64_t recorded = 0, number = 0;
  while (recorded < 50 && read(pipe_ends[0], &number, sizeof number) == sizeof number)
    recorded = number;
  kill(child, SIGKILL);
  while (read(pipe_ends[0], &number, sizeof number) == sizeof number) recorded = number;
  waitpid(child, nullptr, 0);
  close(pipe_ends[0]);
  ASSERT_GE(recorded, 50);
  const AlarmHistory history(file_);
  EXPECT_GE(static_cast<std::int64_t>(history.Falls().size()), recorded);
}

TEST_F(AlarmHistoryTest, IsWhereTheUserKeepsState) {
  EXPECT_EQ(HistoryFile("/a/b.db"), "/a/b.db");
  setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(HistoryFile(""), "/state/fallen/alarms.db");
  unsetenv("XDG_STATE_HOME");
  setenv("HOME", "/home/nurse", 1);
  EXPECT_EQ(HistoryFile(""), "/home/nurse/.local/state/fallen/alarms.db");
}

}  // namespace
}  // namespace fallen
