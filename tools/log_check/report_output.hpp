// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tools/log_check/log_report.hpp"

namespace fallen {

/// The report for people: a summary, a table of the channels, and all that is wrong with offsets.
std::string ReportText(const std::string& log, const LogReport& report);

/// The report for programs: one JSON object, indented, ended with a line break.
std::string ReportJson(const std::string& log, const LogReport& report);

}  // namespace fallen
