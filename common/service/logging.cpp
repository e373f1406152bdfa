// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/logging.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace fallen {

void SetUpLogging(const std::string& service) {
  const auto logger = spdlog::stderr_logger_mt(service);
  // ISO 8601 with the offset from UTC, so that the logs of several hosts can be laid side by side.
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %n %l: %v");
  logger->flush_on(spdlog::level::trace);
  spdlog::set_default_logger(logger);
}

void LogInfo(const std::string& text) { spdlog::info("{}", text); }
void LogWarning(const std::string& text) { spdlog::warn("{}", text); }
void LogError(const std::string& text) { spdlog::error("{}", text); }

std::string RepeatedWarnings::Note(const std::string& kind, const std::string& text,
                                   Clock::time_point now) {
  const auto [entry, is_first] = entries_.try_emplace(kind, Entry{now, 0});
  Entry& state = entry->second;
  if (!is_first && now - state.last < interval_) {
    ++state.unsaid;
    return "";
  }
  const std::string line =
      state.unsaid ? text + " (and " + std::to_string(state.unsaid) + " like it before)" : text;
  state = {now, 0};
  return line;
}

void RepeatedWarnings::Warn(const std::string& kind, const std::string& text) {
  const std::string line = Note(kind, text, Clock::now());
  if (!line.empty()) LogWarning(line);
}

}  // namespace fallen
