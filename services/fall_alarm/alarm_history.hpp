// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fallen/messages/conversions.hpp"
#include "services/fall_alarm/sqlite_database.hpp"

namespace fallen {

/// What the sensors gave when an alarm changed: an LCM log of a few messages.
struct AlarmSnapshot {
  std::int64_t utime = 0;
  std::vector<std::uint8_t> log;
};

/// Everything that happened to alarms, on disk: survives crash and power loss. Also the outbox of
/// what is still to be told to the MQTT broker.
///
/// A change is recorded in one transaction before anybody is told of it. Changes are numbered from
/// 1; a number is never used again. Thread-safe. All throw std::runtime_error "<file>: <why>".
class AlarmHistory {
 public:
  /// Opens or makes a history; missing folders are made.
  explicit AlarmHistory(const std::filesystem::path& file);

  /// Records a change with its snapshot; the first and the newest snapshot of a fall are kept. A
  /// change (id, revision) that is there already is not recorded again.
  /// @return Its number.
  std::int64_t Record(const std::string& robot, const FallAlarm& alarm,
                      const std::optional<AlarmSnapshot>& snapshot = {});

  /// Number that the next change gets: also a number that no id has used.
  std::int64_t NextNumber() const;

  /// Newest change of each fall, the fall that changed last at the end.
  std::vector<NumberedAlarm> Falls() const;
  /// Those that are not cleared.
  std::vector<NumberedAlarm> Active() const;
  /// All changes of a fall, in order; empty if it is not known.
  std::vector<NumberedAlarm> Changes(const std::string& event_id) const;
  std::vector<AlarmSnapshot> Snapshots(const std::string& event_id) const;

  /// First change that the broker has not been told; nothing if it knows all.
  std::optional<NumberedAlarm> FirstUnsent() const;
  /// The broker has the change `number`, and so all before it.
  void MarkSent(std::int64_t number);

  /// Removes falls that were cleared before a time, with all that belongs to them, once they have
  /// been told. @return How many.
  std::int64_t Purge(std::int64_t before_utime);

 private:
  std::vector<NumberedAlarm> Read(const std::string& condition, const std::string& argument) const;

  mutable std::mutex mutex_;
  SqliteDatabase database_;
};

/// The file that a configuration names, or the user's.
std::filesystem::path HistoryFile(const std::string& configured);

}  // namespace fallen
