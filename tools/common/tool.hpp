// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

/// What all command lines share: --help, --version, and how errors are told.
namespace fallen {

/// Exit status of a wrong call or of bad input.
inline constexpr int kExitBadInput = 2;

/// Makes the parser of tool `name` ("fallen-import"), with --version.
std::unique_ptr<CLI::App> MakeToolParser(const std::string& name, const std::string& description);

/// Parses the command line and runs the tool. What is thrown becomes one line on stderr,
/// "<name>: <message>", and kExitBadInput.
/// @param run  Called once the command line is right; returns the exit status.
int RunTool(CLI::App& parser, int argc, const char* const* argv, const std::function<int()>& run);

/// `message` on one line: what libraries say may hold line breaks.
std::string OnOneLine(std::string message);

}  // namespace fallen
