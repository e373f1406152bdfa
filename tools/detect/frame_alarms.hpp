// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "fallen/alarm/alarm_fusion.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/service/configuration.hpp"

namespace fallen {

/// Turns the decisions of a recording into alarms: what a fallen-alarm with an empty history sends.
class FrameAlarms {
 public:
  /// @throws std::runtime_error naming the file of zones if it cannot be used.
  explicit FrameAlarms(const Configuration& configuration);

  /// What the decision about `frame` changes, numbered from 1 on.
  std::vector<NumberedAlarm> Add(const Frame& frame, const Decision& decision);

  /// "alarms 1", and why frames could not be used, if some could not.
  std::string Summary() const;

 private:
  AlarmScope scope_;
  AlarmFusion fusion_;
  std::int64_t changes_ = 0;
  std::int64_t raised_ = 0;
};

}  // namespace fallen
