// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "fallen/detection/detector.hpp"
#include "fallen/messages/log_file.hpp"
#include "tools/common/partial_file.hpp"

namespace fallen {

/// Writes what the services would publish for each frame: NDT_MAP_*, FOREGROUND_*, CLUSTERS_* and
/// FALLEN_PERSONS_*, the same bytes. The log appears once it is complete.
class ResultLog {
 public:
  /// @throws std::runtime_error if `log` cannot be written; so do the others.
  ResultLog(const std::filesystem::path& log, std::string camera);

  void Write(const Frame& frame, const FrameResult& result);
  void Close();

 private:
  PartialFile file_;
  LogWriter writer_;
  std::string camera_;
};

}  // namespace fallen
