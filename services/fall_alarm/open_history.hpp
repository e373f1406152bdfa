// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "services/fall_alarm/alarm_history.hpp"

namespace fallen {

/// A history to work with, whatever the file is like.
struct OpenedHistory {
  std::unique_ptr<AlarmHistory> history;
  std::string note;  ///< one line: what was wrong, and what is done instead; empty: nothing
};

/// Opens a history for a service that must come up. A damaged file is set aside, beside itself as
/// <file>.damaged-<n>, and a new one begun; where no file can be used, the history is in memory.
OpenedHistory OpenHistoryAnyhow(const std::filesystem::path& file);

/// Holds a history for one process: two would tell every change twice.
class HistoryLock {
 public:
  /// @throws std::runtime_error "<file>: in use by another fallen-alarm".
  explicit HistoryLock(const std::filesystem::path& history);
  ~HistoryLock();
  HistoryLock(const HistoryLock&) = delete;
  HistoryLock& operator=(const HistoryLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace fallen
