// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fallen/fall_alarm_t.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "tests/integration/lcm_recorder.hpp"
#include "tests/integration/private_network.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/seen_place.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen::testing_support {

inline constexpr std::chrono::seconds kAlarmTimeout{30};
inline constexpr std::int64_t kFirstUtime = 1'700'000'000'000'000;
inline const Eigen::Vector3d kPerson{2, 0, 0.15};
inline const Eigen::Vector3d kOther{2, 1.2, 0.15};

/// fallen-alarm as a process, frames for it, and what it says on LCM.
class Alarm : public testing::Test {
 protected:
  Alarm() : url_(EnterPrivateNetwork()), recorder_(url_) {}

  void StartAlarm(const std::string& yaml = "", const std::string& robot = "r2") {
    std::ofstream(folder_ / "alarm.yaml") << "service: {robot: " << robot << "}\n" << yaml;
    alarm_.emplace(
        std::vector<std::string>{Program("fallen-alarm"), "--lcm-url", url_, "--config",
                                 (folder_ / "alarm.yaml").string(), "--history", History()},
        folder_.path());
    const bool is_up = recorder_.HandleUntil(
        [&] { return recorder_.Status("alarm").pid == alarm_->pid(); }, kAlarmTimeout);
    ASSERT_TRUE(is_up) << alarm_->StandardError();
  }
  std::string History() const { return (folder_ / "alarms.db").string(); }

  /// Frames at 10 Hz of message time, as fast as they go, with persons at these places.
  void Show(int frames, const std::vector<Eigen::Vector3d>& persons) {
    for (int i = 0; i < frames; ++i, ++seq_) {
      Decision decision = seen_place::Empty(seen_place::LookAt({0, 0.5, 1}, {2, 0.5, 0.15}));
      for (const Eigen::Vector3d& person : persons) seen_place::AddCluster(decision, person, 0.99);
      const auto bytes =
          EncodeMessage(ToMessage(Header{kFirstUtime + 100'000 * seq_, seq_, "FRONT"}, decision));
      recorder_.lcm().publish("FALLEN_PERSONS_FRONT", bytes.data(),
                              static_cast<unsigned>(bytes.size()));
      recorder_.HandleFor(std::chrono::milliseconds(2));
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
    return recorder_.HandleUntil([&] { return AlarmsOnLcm().size() >= count; }, kAlarmTimeout);
  }
  void Answer(const std::string& event_id, bool closes = false) {
    const auto bytes = EncodeMessage(
        ToMessage(AlarmAnswer{kFirstUtime + 100'000 * seq_, event_id, "nurse", closes}));
    recorder_.lcm().publish("FALL_ALARM_ACK", bytes.data(), static_cast<unsigned>(bytes.size()));
  }
  void StopAlarm() {
    EXPECT_EQ(alarm_->Stop(), 0) << alarm_->StandardError();
    alarm_.reset();
  }
  void KillAlarm() {
    alarm_->Signal(SIGKILL);
    EXPECT_EQ(alarm_->WaitForExit(std::chrono::seconds(10)), 128 + SIGKILL);
    alarm_.reset();
  }
  bool WaitForStatusText(const std::string& part) {
    return recorder_.HandleUntil(
        [&] { return recorder_.Status("alarm").text.find(part) != std::string::npos; },
        kAlarmTimeout);
  }

  const std::string url_;
  TemporaryFolder folder_;
  LcmRecorder recorder_;
  std::optional<ChildProcess> alarm_;
  std::int64_t seq_ = 0;
};

}  // namespace fallen::testing_support
