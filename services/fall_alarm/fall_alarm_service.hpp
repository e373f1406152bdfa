// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fallen/alarm/alarm_fusion.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/service/stage_loop.hpp"
#include "services/fall_alarm/alarm_history.hpp"
#include "services/fall_alarm/snapshot_keeper.hpp"

namespace fallen {

/// What a FallAlarmService is set up with.
struct FallAlarmSetup {
  AlarmConfig config;
  AlarmScope scope;
  std::string camera;  ///< the only one to listen to; empty: all
  bool has_snapshots = true;
  bool has_broker = false;   ///< somebody tells an MQTT broker what is in the history
  std::string history_note;  ///< why the history is not what was asked for; empty: it is
};

/// FALLEN_PERSONS_* of several cameras -> FALL_ALARM, with a history; answers come on
/// FALL_ALARM_ACK.
///
/// A change is in the history before it is sent. Where the history cannot take it, it is sent all
/// the same, as number 0, and recorded as soon as that works. Active alarms are repeated at 1 Hz,
/// cleared ones for some seconds; alarms that were active when the process ended go on.
class FallAlarmService {
 public:
  /// @param history  Must outlive this.
  /// @throws std::invalid_argument if the configuration or a zone is out of range.
  FallAlarmService(lcm::LCM& lcm, const StageOptions& options, FallAlarmSetup setup,
                   AlarmHistory& history);

  StageLoop& loop() { return loop_; }

  /// Repeats what is current and tries again what failed: once a second, in the worker.
  void EverySecond();

  /// Somebody's answer from elsewhere than LCM, at the time of the newest frame. Thread-safe.
  void Answer(const AlarmAnswer& answer);
  /// What is wrong with the MQTT broker, empty for nothing. Thread-safe.
  void SetBrokerTrouble(const std::string& trouble);

 private:
  struct Told {
    fall_alarm_t message;
    int repetitions = 0;
  };
  void Decide(const fallen_persons_t& message);
  void Obey(AlarmAnswer answer);
  void Tell(const std::vector<FallAlarm>& changes);
  void Send(const FallAlarm& change, std::int64_t number);
  /// @return Number in the history; 0 if it could not be recorded.
  std::int64_t Record(const FallAlarm& change);
  void UpdateState();

  const FallAlarmSetup setup_;
  AlarmHistory& history_;
  AlarmFusion fusion_;
  std::unique_ptr<SnapshotKeeper> snapshots_;
  std::map<std::string, Told> told_;  ///< newest of each alarm that is repeated, by id
  std::vector<FallAlarm> unrecorded_;
  std::string history_trouble_;
  std::int64_t newest_utime_ = 1;
  std::int64_t seen_without_pose_ = 0;
  std::mutex broker_mutex_;
  std::string broker_trouble_;  // guarded by it
  StageLoop loop_;
};

}  // namespace fallen
