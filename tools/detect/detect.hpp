// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "tools/common/detector_setup.hpp"
#include "tools/detect/frame_json.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

/// What fallen-detect is asked to do.
struct DetectOptions {
  std::filesystem::path input;
  std::optional<std::string> camera;
  DetectorOptions detector;
  std::optional<std::filesystem::path> output;  ///< log of the stages' messages
  std::string json = "-";                       ///< file of one line a frame; "-": stdout
  ListedPersons listed = ListedPersons::kAccepted;
  bool alarms = false;    ///< fuse decisions into alarms
  bool realtime = false;  ///< at the recording's pace, dropping what comes too late
};

struct DetectSummary {
  std::int64_t frames = 0;     ///< depth images that the input gave
  std::int64_t decisions = 0;  ///< frames that were decided
  std::int64_t persons = 0;    ///< accepted, over all frames
  std::int64_t dropped = 0;    ///< too late for --realtime
  Damage damage;
  StageTimes median_milliseconds;
  std::string alarms;  ///< what became of them, see FrameAlarms::Summary; "" if not asked for
};

/// Runs the detector over a recording. @throws std::runtime_error for bad input or output.
DetectSummary RunDetect(const DetectOptions& options);

/// "frames 98 decisions 98 persons 3 damaged 0"; with " dropped n" if there are any, and the
/// alarms if they were asked for.
std::string SummaryLine(const DetectSummary& summary);

}  // namespace fallen
