// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <vector>

/// Programs that end by themselves.
namespace fallen {

/// How a program ended and what it said.
struct ProgramOutcome {
  int status = -1;  ///< exit status, 128 + signal if it died of one; -1 if it had to be killed
  std::string out;
  std::string err;
};

/// Below the time that a test has.
inline constexpr std::chrono::seconds kProgramTimeout{240};

/// Runs a command, sought in PATH if it has no slash, to its end. No shell is involved.
ProgramOutcome RunCommand(const std::vector<std::string>& command,
                          std::chrono::milliseconds timeout = kProgramTimeout);

/// Runs `program` of the build's bin folder to its end.
ProgramOutcome RunProgram(const std::string& program, const std::vector<std::string>& arguments);

/// Runs a script with sh.
ProgramOutcome RunShell(const std::string& script);

/// True if `text` is one line, ended.
bool IsOneLine(const std::string& text);

}  // namespace fallen
