// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "fallen/geometry/enum_names.hpp"

namespace fallen {

/// How bad a finding is.
enum class Verdict {
  kOk,
  kWarning,  ///< something will be missing, persons are found all the same
  kError,    ///< no person will be found
};
constexpr auto EnumNames(Verdict) {
  return EnumTable<Verdict, 3>{
      {{Verdict::kOk, "ok"}, {Verdict::kWarning, "warning"}, {Verdict::kError, "error"}}};
}

/// What one check of the machine came to.
struct Finding {
  std::string check;  ///< "receive buffer"
  Verdict verdict = Verdict::kOk;
  std::string text;    ///< what was found, and what was expected if it is not ok
  std::string remedy;  ///< the command that mends it, "" if ok
};

inline Finding Good(const std::string& check, const std::string& text) {
  return {check, Verdict::kOk, text, ""};
}

/// One line a finding, followed by its remedy, and a last line with the sums.
void PrintFindings(std::ostream& out, const std::vector<Finding>& findings);
/// {"findings":[{"check":…,"verdict":…,"text":…,"remedy":…}],"errors":n,"warnings":n}
void PrintFindingsAsJson(std::ostream& out, const std::vector<Finding>& findings);

/// 0 if nothing essential is wrong, else 1.
int ExitStatusOf(const std::vector<Finding>& findings);

}  // namespace fallen
