// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fallen/messages/log_file.hpp"

/// What is in an LCM log, and what is wrong with it.
namespace fallen {

/// A message of one of our types that cannot be decoded, or says what makes no sense.
struct BadMessage {
  std::int64_t offset = 0;  ///< of its event in the log
  std::string reason;
};

struct ChannelReport {
  std::int64_t messages = 0;
  std::int64_t bytes = 0;        ///< of their data
  std::int64_t first_utime = 0;  ///< earliest and latest time of logging [us]
  std::int64_t last_utime = 0;
  std::map<std::string, std::int64_t>
      types;                 ///< messages by type; "unknown 0x..." by hash, if not ours
  std::int64_t missing = 0;  ///< sequence numbers left out: messages that were sent, but not logged
  std::int64_t out_of_order = 0;  ///< messages whose sequence number is not above the one before
  std::vector<BadMessage> bad;

  double span_s() const { return static_cast<double>(last_utime - first_utime) * 1e-6; }
  /// Messages per second; 0 for a single message.
  double rate_hz() const {
    return last_utime > first_utime ? static_cast<double>(messages - 1) / span_s() : 0;
  }
};

struct LogReport {
  std::int64_t size_bytes = 0;
  std::int64_t events = 0;
  std::map<std::string, ChannelReport> channels;
  std::vector<LogDamage> damage;

  std::int64_t damaged_bytes() const;
  std::int64_t bad_messages() const;
  /// No place that cannot be read and no bad message. Missing ones are no damage to the log.
  bool is_clean() const { return damage.empty() && bad_messages() == 0; }
};

/// Reads the whole log.
/// @param repaired  If given, every event is written to it but for bad messages.
/// @param progress  If given, is told the share that was read.
/// @throws std::runtime_error if the log cannot be opened, or `repaired` not be written.
LogReport CheckLog(const std::filesystem::path& log, LogWriter* repaired = nullptr,
                   const std::function<void(double)>& progress = {});

}  // namespace fallen
