// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/frame_alarms.hpp"

#include "fallen/service/load_files.hpp"

namespace fallen {
namespace {

/// As a history without any entry has it.
AlarmScope FromTheFirstNumber(AlarmScope scope) {
  scope.first_number = 1;
  return scope;
}

}  // namespace

FrameAlarms::FrameAlarms(const Configuration& configuration)
    : scope_(FromTheFirstNumber(LoadAlarmScopeFor(configuration))),
      fusion_(configuration.alarm, scope_) {}

std::vector<NumberedAlarm> FrameAlarms::Add(const Frame& frame, const Decision& decision) {
  std::vector<NumberedAlarm> changes;
  for (FallAlarm& change : fusion_.Add(frame.utime, frame.sensor_name, decision)) {
    if (change.change == AlarmChange::kRaised) ++raised_;
    changes.push_back({scope_.robot, ++changes_, std::move(change)});
  }
  return changes;
}

std::string FrameAlarms::Summary() const {
  std::string text = "alarms " + std::to_string(raised_);
  if (const std::int64_t count = fusion_.frames_without_pose(); count > 0)
    text +=
        " (" + std::to_string(count) + " frames without a pose say nothing: see ndt.without_pose)";
  return text;
}

}  // namespace fallen
