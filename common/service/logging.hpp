// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <map>
#include <string>

/// Logging of services: to stderr, ISO time and the service's name in every line.
namespace fallen {

/// Sets up the log of the process: once, before anything is logged.
/// @param service  As in "fallen-<service>".
void SetUpLogging(const std::string& service);

void LogInfo(const std::string& text);
void LogWarning(const std::string& text);
void LogError(const std::string& text);

/// Says the first of a kind of event, then at most one line per interval with the count since.
/// Not thread-safe.
class RepeatedWarnings {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RepeatedWarnings(Clock::duration interval = std::chrono::seconds(10))
      : interval_(interval) {}

  /// The line to log now, or "" for now.
  /// @param kind  What is counted together, e.g. "late".
  std::string Note(const std::string& kind, const std::string& text, Clock::time_point now);

  /// Logs what Note() returns, as a warning.
  void Warn(const std::string& kind, const std::string& text);

 private:
  struct Entry {
    Clock::time_point last;
    long unsaid = 0;
  };
  Clock::duration interval_;
  std::map<std::string, Entry> entries_;
};

}  // namespace fallen
