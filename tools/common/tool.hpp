// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

/// The frame of a command line tool: parse, run, tell errors.
namespace fallen {

/// Makes the parser of tool `name` ("fallen-import"), with --help and --version.
std::unique_ptr<CLI::App> MakeToolParser(const std::string& name, const std::string& description);

/// Parses the command line and runs the tool. A wrong call and what `run` throws become one line on
/// stderr, "<name>: <message>", and kExitWrongCall.
/// @param run  Called once the command line is right; returns the exit status.
int RunTool(CLI::App& parser, int argc, const char* const* argv, const std::function<int()>& run);

}  // namespace fallen
