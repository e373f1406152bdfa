// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "fallen/service_status_t.hpp"

namespace fallen {

/// What each service last said about itself, and how long ago. Not thread-safe.
class ServiceTable {
 public:
  using Clock = std::chrono::steady_clock;

  /// Takes a status. @throws std::invalid_argument if it cannot be decoded.
  void Take(std::span<const std::uint8_t> bytes, Clock::time_point now);

  /// A list, by name: the fields of service_status_t, `state` in words, `silent_s` since the last.
  nlohmann::json ToJson(Clock::time_point now) const;

 private:
  struct Heard {
    service_status_t status;
    Clock::time_point at;
  };
  // Workers of one service, and services of several cameras, say their own: by process.
  std::map<std::pair<std::string, std::int64_t>, Heard> heard_;
};

}  // namespace fallen
