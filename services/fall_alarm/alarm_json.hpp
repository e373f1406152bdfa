// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "fallen/messages/conversions.hpp"

namespace fallen {

/// A change of an alarm as JSON: the fields of fall_alarm_t, the header's as `number`, `utime` and
/// `camera`; `event_type` is raised, updated, acknowledged or cleared.
nlohmann::ordered_json AlarmJson(const NumberedAlarm& alarm);

/// Active alarms: {"active": 2, "alarms": [...]}.
nlohmann::ordered_json ActiveAlarmsJson(std::span<const NumberedAlarm> alarms);

/// JSON on one line. Texts that are no UTF-8 (names come from messages) are mended.
std::string JsonLine(const nlohmann::ordered_json& json);

}  // namespace fallen
