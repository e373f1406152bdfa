// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace fallen {

/// How a program ended and what it said.
struct ProgramOutcome {
  int status = -1;  ///< exit status; -1 if it was killed
  std::string out;
  std::string err;
};

/// Runs `program` of the build's bin folder to its end. No shell is involved.
ProgramOutcome RunProgram(const std::string& program, const std::vector<std::string>& arguments);

/// True if `text` is one line, ended.
bool IsOneLine(const std::string& text);

}  // namespace fallen
