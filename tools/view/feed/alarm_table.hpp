// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <span>

#include "fallen/messages/conversions.hpp"

namespace fallen {

/// The newest of what is known of each fall, for the page. Not thread-safe.
class AlarmTable {
 public:
  /// Takes a FALL_ALARM message. @return Whether it says anything new: alarms are repeated at 1 Hz.
  /// @throws std::invalid_argument if it cannot be used.
  bool Take(std::span<const std::uint8_t> bytes);

  /// A list, the newest fall first: the fields of fall_alarm_t, `change` and `frame` in words.
  nlohmann::json ToJson() const;

 private:
  std::deque<NumberedAlarm> alarms_;  // newest first
};

}  // namespace fallen
