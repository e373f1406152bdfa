// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "tools/evaluate_alarm/drive_judgement.hpp"

namespace fallen {

/// Figures over drives: `drives`, `hours`, `falls` that came into view, `person_free` drives and
/// hours, and for `alarm` and `single_frame` each: falls `found`, `share_found`,
/// `share_within_3_s`, `median_seconds`, `p90_seconds` (falls that were not found count as never:
/// null), `median_views`, `false_alarms` with `_per_hour`, the same in person-free drives; for the
/// alarm `left`, `cleared` and `median_seconds_until_cleared`. What has no value is null.
nlohmann::ordered_json AlarmFigures(std::span<const DriveOutcome> drives);

/// Every drive by itself.
nlohmann::ordered_json DriveList(std::span<const DriveOutcome> drives);

}  // namespace fallen
