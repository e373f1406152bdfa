// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "tools/common/partial_file.hpp"

namespace fallen {

/// Writes what the services would publish for each frame: NDT_MAP_*, FOREGROUND_*, CLUSTERS_*,
/// FALLEN_PERSONS_* and, where there are any, FALL_ALARM, the same bytes. The log appears once it
/// is complete.
class ResultLog {
 public:
  /// @throws std::runtime_error if `log` cannot be written; so do the others.
  ResultLog(const std::filesystem::path& log, std::string camera);

  /// @param alarms  What the frame changes.
  void Write(const Frame& frame, const FrameResult& result,
             const std::vector<NumberedAlarm>& alarms);
  void Close();

 private:
  PartialFile file_;
  LogWriter writer_;
  std::string camera_;
};

}  // namespace fallen
