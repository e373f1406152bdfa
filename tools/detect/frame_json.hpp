// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// Which clusters a line lists.
enum class ListedPersons {
  kAccepted,  ///< those that count as fallen persons
  kAll,       ///< every candidate, with `accepted` to tell them apart
};

/// The decision about a frame as one line of JSON, without the line break. Numbers are written so
/// that reading them gives the same double.
/// @param index   Number of the frame in its recording, from 0.
/// @param alarms  What the frame changes; nothing: alarms were not asked for.
std::string FrameJson(std::int64_t utime, std::int64_t index, const Decision& decision,
                      const StageTimes& milliseconds, ListedPersons listed,
                      const std::optional<std::vector<NumberedAlarm>>& alarms = std::nullopt);

}  // namespace fallen
