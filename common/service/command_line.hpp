// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

/// Command lines of all programs: --help, --version, and one line on stderr for a wrong call.
///
/// Includes CLI11: meant for .cpp files.
namespace fallen {

/// Exit statuses of all programs.
inline constexpr int kExitSuccess = 0;
inline constexpr int kExitFailure = 1;    ///< the work failed, the call was right
inline constexpr int kExitWrongCall = 2;  ///< wrong call or bad input

/// Sets up what all programs share: their name in messages, --help and --version.
void AddStandardFlags(CLI::App& app, const std::string& program, const std::string& description);

/// Parses the command line and runs the program. A wrong call and what `run` throws become one line
/// on stderr, "<program>: <message>".
/// @param run  Called once the command line is right; returns the exit status.
/// @return That of `run`; after --help or --version kExitSuccess; kExitWrongCall.
int RunCommandLine(CLI::App& app, int argc, const char* const* argv,
                   const std::function<int()>& run);

}  // namespace fallen
