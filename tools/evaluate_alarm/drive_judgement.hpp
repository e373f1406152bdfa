// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "fallen/alarm/alarm_fusion.hpp"
#include "tools/evaluate_alarm/drive_trace.hpp"

namespace fallen {

/// What one way of raising alarms made of a drive.
struct AlarmOutcome {
  std::optional<double> seconds_until;  ///< from the person's coming into view to the alarm
  int views = 0;                        ///< viewpoints that the alarm rested on
  int false_alarms = 0;                 ///< at places without a fallen person, each counted once
  std::optional<double> seconds_until_cleared;  ///< from the person's leaving; the alarm's only
};

struct DriveOutcome {
  std::string log;
  double seconds = 0;
  bool has_person = false;      ///< at some time
  bool came_into_view = false;  ///< enough of the person, see TracedFrame: a fall to be found
  bool person_left = false;     ///< after that, and the alarm was up
  AlarmOutcome alarm;
  AlarmOutcome single_frame;  ///< every accepted cluster of any frame is an alarm
};

/// Judges a drive by its ground truth.
///
/// An alarm or cluster is right if it lies in the person's box, or within 0.3 m of it. What is
/// raised right at once when the person comes into view, or before, took 0 s.
/// @param fusion  A fresh one.
DriveOutcome JudgeDrive(const DriveTrace& trace, AlarmFusion fusion);

}  // namespace fallen
