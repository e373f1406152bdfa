// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "fallen/messages/log_file.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/view/feed/alarm_table.hpp"
#include "tools/view/feed/feed.hpp"
#include "tools/view/feed/replay_report.hpp"
#include "tools/view/feed/scene_assembler.hpp"

namespace fallen {

/// The camera of which `log` holds decisions, so that what a robot decided can be shown as it was.
/// @param camera  If given, only that one. @return Nothing if there are none, or of several
/// cameras.
/// @throws std::runtime_error if the file cannot be opened.
std::optional<std::string> CameraWithDecisions(const std::filesystem::path& log,
                                               const std::optional<std::string>& camera);

/// Fills a feed with what the services once published, from a log.
class RecordedSource {
 public:
  /// @param feed  Must outlive this. @throws std::runtime_error if the log cannot be opened.
  RecordedSource(Feed& feed, const std::filesystem::path& log, const std::string& camera,
                 const std::string& name);

  /// As ReplaySource::Run.
  void Run(const std::atomic<bool>& is_stopping);

 private:
  void Take(const LogEvent& event);

  Feed& feed_;
  LogReader reader_;
  SceneAssembler assembler_;
  AlarmTable alarms_;
  ReplayReport report_;
  Damage unusable_;
};

}  // namespace fallen
