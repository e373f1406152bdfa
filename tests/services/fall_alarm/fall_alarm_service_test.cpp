// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/fall_alarm_service.hpp"

#include <gmock/gmock.h>

#include "fallen/messages/conversions.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/seen_place.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using seen_place::AddCluster;
using seen_place::Empty;
using seen_place::LookAt;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing_support::MemqLink;

constexpr std::int64_t kStart = 1'700'000'000'000'000;
const Eigen::Vector3d kPerson{2, 0, 0.15};
const Eigen::Isometry3d kView = LookAt({0, 0, 1}, kPerson);

class FallAlarmServiceTest : public testing::Test {
 protected:
  FallAlarmServiceTest() { Restart(); }

  void Restart(FallAlarmSetup setup = {}) {
    service_.reset();
    link_ = std::make_unique<MemqLink>();
    link_->Collect("FALL_ALARM");
    history_ = std::make_unique<AlarmHistory>(folder_.path() / "alarms.db");
    service_ = std::make_unique<FallAlarmService>(link_->lcm(), MemqLink::Options("alarm"),
                                                  std::move(setup), *history_);
    answers_ = 0;
  }

  void Show(double seconds, bool has_person, const std::string& camera = "FRONT") {
    for (int i = 0; i < 10 * seconds; ++i, ++seq_) {
      Decision decision = Empty(kView);
      if (has_person) AddCluster(decision, kPerson, 0.99);
      link_->SendMessage("FALLEN_PERSONS_" + camera,
                         ToMessage(Header{kStart + 100'000 * seq_, seq_, camera}, decision));
      link_->Exchange(service_->loop());
    }
  }
  /// Alarms sent since the last call.
  std::vector<fall_alarm_t> Alarms() {
    std::vector<fall_alarm_t> alarms;
    for (; answers_ < link_->answers().size(); ++answers_)
      alarms.push_back(DecodeMessage<fall_alarm_t>(link_->answers()[answers_]).message.value());
    return alarms;
  }
  std::vector<int> Changes() {
    std::vector<int> changes;
    for (const fall_alarm_t& alarm : Alarms()) changes.push_back(alarm.change);
    return changes;
  }
  void Tick() {
    service_->EverySecond();
    link_->Exchange(service_->loop());
  }
  service_status_t Status() { return service_->loop().reporter().Status(); }

  TemporaryFolder folder_;
  std::unique_ptr<MemqLink> link_;
  std::unique_ptr<AlarmHistory> history_;
  std::unique_ptr<FallAlarmService> service_;
  std::size_t answers_ = 0;
  std::int64_t seq_ = 0;
};

TEST_F(FallAlarmServiceTest, RaisesAcknowledgesAndClears) {
  Show(4, true);
  auto alarms = Alarms();
  ASSERT_THAT(alarms, SizeIs(1));
  EXPECT_EQ(alarms[0].change, fall_alarm_t::RAISED);
  EXPECT_EQ(alarms[0].robot, "robot");
  EXPECT_EQ(alarms[0].header.seq, 1);
  EXPECT_EQ(alarms[0].header.sensor_name, "FRONT");
  EXPECT_NEAR(alarms[0].position[0], 2, 1e-9);

  link_->SendMessage("FALL_ALARM_ACK",
                     ToMessage(AlarmAnswer{kStart + 1, alarms[0].event_id, "nurse"}));
  link_->Exchange(service_->loop());
  const std::string id = alarms[0].event_id;
  alarms = Alarms();
  ASSERT_THAT(alarms, SizeIs(1));
  EXPECT_EQ(alarms[0].change, fall_alarm_t::ACKNOWLEDGED);
  EXPECT_EQ(alarms[0].event_id, id);
  EXPECT_EQ(alarms[0].acknowledged_by, "nurse");

  Show(10, false);
  EXPECT_THAT(Changes(), ElementsAre(fall_alarm_t::CLEARED));
  EXPECT_THAT(history_->Changes(id), SizeIs(3));
  EXPECT_FALSE(history_->FirstUnsent()) << "there is no broker to be told";
  EXPECT_EQ(Status().published, 3);
  EXPECT_EQ(Status().state, service_status_t::RUNNING);
}

/// Looks into the history at the moment at which an alarm arrives.
struct HistoryWatcher {
  const AlarmHistory& history;
  int recorded = 0;
  void Receive(const lcm::ReceiveBuffer*, const std::string&, const fall_alarm_t* alarm) {
    recorded += static_cast<int>(history.Changes(alarm->event_id).size());
  }
};

TEST_F(FallAlarmServiceTest, IsInTheHistoryBeforeItIsSent) {
  HistoryWatcher watcher{*history_};
  link_->lcm().subscribe("FALL_ALARM", &HistoryWatcher::Receive, &watcher);
  Show(4, true);
  EXPECT_EQ(watcher.recorded, 1);
}

TEST_F(FallAlarmServiceTest, RepeatsWhatIsCurrent) {
  Show(4, true);
  const fall_alarm_t raised = Alarms().at(0);
  for (int i = 0; i < 10; ++i) Tick();
  const auto repeated = Alarms();
  ASSERT_THAT(repeated, SizeIs(10));
  EXPECT_EQ(EncodeMessage(repeated.back()), EncodeMessage(raised));
  EXPECT_EQ(Status().published, 1) << "repeating is no result";
  Show(10, false);
  Alarms();
  for (int i = 0; i < 10; ++i) Tick();
  EXPECT_THAT(Alarms(), SizeIs(5)) << "that it is over, for some seconds";
}

TEST_F(FallAlarmServiceTest, GoesOnAfterARestart) {
  Show(4, true);
  const fall_alarm_t raised = Alarms().at(0);
  Restart();
  Tick();
  EXPECT_EQ(EncodeMessage(Alarms().at(0)), EncodeMessage(raised));
  Show(4, true);
  EXPECT_THAT(Alarms(), IsEmpty()) << "the same person is the same alarm";
  Show(10, false);
  const auto cleared = Alarms();
  ASSERT_THAT(cleared, SizeIs(1));
  EXPECT_EQ(cleared[0].event_id, raised.event_id);
  Show(4, true);
  EXPECT_NE(Alarms().at(0).event_id, raised.event_id);
}

TEST_F(FallAlarmServiceTest, ListensToAllCamerasOrToOne) {
  Show(4, true, "REAR");
  EXPECT_THAT(Changes(), ElementsAre(fall_alarm_t::RAISED));
  FallAlarmSetup setup;
  setup.camera = "FRONT";
  Show(10, false, "REAR");
  Restart(setup);
  Show(4, true, "REAR");
  EXPECT_THAT(Alarms(), IsEmpty());
  Show(4, true, "FRONT");
  EXPECT_THAT(Changes(), ElementsAre(fall_alarm_t::RAISED));
}

TEST_F(FallAlarmServiceTest, CamerasThatCountByThemselvesAreNoLoss) {
  for (int i = 0; i < 10; ++i)
    for (const auto& [camera, seq] : {std::pair{"FRONT", i}, {"REAR", 1000 + i}}) {
      link_->SendMessage(std::string("FALLEN_PERSONS_") + camera,
                         ToMessage(Header{kStart + i, seq, camera}, Empty(kView)));
      link_->Exchange(service_->loop());
    }
  EXPECT_EQ(Status().received, 20);
  EXPECT_EQ(Status().lost_upstream, 0);
}

TEST_F(FallAlarmServiceTest, AnswersFromElsewhereAreCheckedToo) {
  Show(4, true);
  Alarms();
  service_->Answer({0, "", std::string(1000, 'x')});
  link_->Exchange(service_->loop());
  EXPECT_THAT(Alarms(), IsEmpty());
  EXPECT_EQ(Status().dropped_damaged, 1);
  service_->Answer({0, "", "MQTT", true});
  link_->Exchange(service_->loop());
  const auto alarms = Alarms();
  ASSERT_THAT(alarms, SizeIs(1));
  EXPECT_EQ(alarms[0].change, fall_alarm_t::CLEARED);
  EXPECT_EQ(alarms[0].cleared_by, "MQTT");
  EXPECT_EQ(alarms[0].cleared_utime, kStart + 100'000 * (seq_ - 1)) << "time is that of frames";
}

TEST_F(FallAlarmServiceTest, BrokenMessagesAreCountedAndItGoesOn) {
  link_->Send("FALLEN_PERSONS_FRONT", {1, 2, 3});
  link_->Send("FALL_ALARM_ACK", {1, 2, 3});
  link_->Exchange(service_->loop());
  EXPECT_EQ(Status().dropped_damaged, 2);
  Show(4, true);
  EXPECT_THAT(Changes(), ElementsAre(fall_alarm_t::RAISED));
}

TEST_F(FallAlarmServiceTest, SaysWhatIsWrong) {
  Decision decision = Empty(kView);
  decision.frame = MapFrame::kLevel;
  link_->SendMessage("FALLEN_PERSONS_FRONT", ToMessage(Header{kStart, 0, "FRONT"}, decision));
  link_->Exchange(service_->loop());
  Tick();
  EXPECT_EQ(Status().state, service_status_t::DEGRADED);
  EXPECT_THAT(Status().text, HasSubstr("without a pose"));
  Tick();
  EXPECT_EQ(Status().text, "");
  service_->SetBrokerTrouble("mqtt: broker:8883: Connection refused");
  link_->Exchange(service_->loop());
  EXPECT_EQ(Status().text, "mqtt: broker:8883: Connection refused");
}

TEST_F(FallAlarmServiceTest, AHistoryThatFailsDelaysNoAlarmAndLosesNone) {
  {
    const SqliteDatabase other(folder_.path() / "alarms.db");
    other.Run("ALTER TABLE changes RENAME TO away");
  }
  Show(4, true);
  const auto alarms = Alarms();
  ASSERT_THAT(alarms, SizeIs(1));
  EXPECT_EQ(alarms[0].header.seq, 0) << "no number yet";
  EXPECT_EQ(Status().state, service_status_t::DEGRADED);
  EXPECT_THAT(Status().text, HasSubstr("no such table"));
  {
    const SqliteDatabase other(folder_.path() / "alarms.db");
    other.Run("ALTER TABLE away RENAME TO changes");
  }
  Tick();
  EXPECT_EQ(Alarms().at(0).header.seq, 1);
  EXPECT_THAT(history_->Changes(alarms[0].event_id), SizeIs(1));
  EXPECT_EQ(Status().state, service_status_t::RUNNING);
}

TEST_F(FallAlarmServiceTest, KeepsASnapshotOfTheFrame) {
  Show(4, true);
  const auto snapshots = history_->Snapshots(Alarms().at(0).event_id);
  ASSERT_THAT(snapshots, SizeIs(1));
  LogReader reader(
      folder_.Write("snapshot.lcm", {snapshots[0].log.begin(), snapshots[0].log.end()}));
  EXPECT_EQ(reader.Next()->channel, "FALLEN_PERSONS_FRONT");
}

}  // namespace
}  // namespace fallen
