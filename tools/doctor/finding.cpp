// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/finding.hpp"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

namespace fallen {
namespace {

constexpr int kVerdictWidth = 9;  // "warning" and two blanks

std::ptrdiff_t Count(const std::vector<Finding>& findings, Verdict verdict) {
  return std::count_if(findings.begin(), findings.end(),
                       [&](const Finding& finding) { return finding.verdict == verdict; });
}

}  // namespace

void PrintFindings(std::ostream& out, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    out << std::left << std::setw(kVerdictWidth) << EnumName(finding.verdict) << finding.check
        << ": " << finding.text << "\n";
    if (!finding.remedy.empty())
      out << std::setw(kVerdictWidth) << ""
          << "-> " << finding.remedy << "\n";
  }
  out << "errors " << Count(findings, Verdict::kError) << " warnings "
      << Count(findings, Verdict::kWarning) << "\n";
}

void PrintFindingsAsJson(std::ostream& out, const std::vector<Finding>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings)
    list.push_back({{"check", finding.check},
                    {"verdict", EnumName(finding.verdict)},
                    {"text", finding.text},
                    {"remedy", finding.remedy}});
  const nlohmann::ordered_json report = {{"findings", list},
                                         {"errors", Count(findings, Verdict::kError)},
                                         {"warnings", Count(findings, Verdict::kWarning)}};
  // What stands in files and comes from libraries may be no UTF-8: replaced, not thrown at.
  out << report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
}

int ExitStatusOf(const std::vector<Finding>& findings) {
  return Count(findings, Verdict::kError) > 0 ? 1 : 0;
}

}  // namespace fallen
