// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/alarm/fall_alarm.hpp"

namespace fallen::testing_support {

inline constexpr std::int64_t kRaisedUtime = 1'700'000'000'000'000;

/// A fall whose last change is `change`, the `revision`-th.
inline FallAlarm SampleFall(const std::string& id, std::int32_t revision, AlarmChange change) {
  FallAlarm alarm;
  alarm.id = id;
  alarm.revision = revision;
  alarm.change = change;
  alarm.change_utime = kRaisedUtime + 1'000'000 * revision;
  alarm.camera = "FRONT";
  alarm.first_utime = kRaisedUtime - 500'000;
  alarm.raised_utime = kRaisedUtime;
  if (change == AlarmChange::kCleared) alarm.cleared_utime = alarm.change_utime;
  alarm.position = {1.25, -2, 0.2};
  alarm.box = {{1.2, -2.1, 0.15}, {1.7, 0.6, 0.3}, 0.5};
  alarm.probability = 0.97;
  alarm.best_probability = 0.95;
  alarm.views = 2;
  alarm.frames = 12;
  return alarm;
}

}  // namespace fallen::testing_support
