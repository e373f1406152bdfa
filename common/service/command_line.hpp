// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
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

/// Parses the command line.
/// @return Nothing to go on; else the status to exit with: after --help or --version 0, after a
/// wrong
///         call 2, with one line on stderr.
std::optional<int> ParseCommandLine(CLI::App& app, int argc, const char* const* argv);

/// Prints "<program>: <text>" as one line on stderr. @return kExitWrongCall.
int ReportWrongCall(const std::string& program, const std::string& text);

}  // namespace fallen
