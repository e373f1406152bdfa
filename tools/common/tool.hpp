// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

/// The frame of a command line tool.
namespace fallen {

/// Makes the parser of tool `name` ("fallen-import"), with --help and --version.
std::unique_ptr<CLI::App> MakeToolParser(const std::string& name, const std::string& description);

/// RunCommandLine (fallen/service/command_line.hpp), for files that need not know CLI11.
int RunTool(CLI::App& parser, int argc, const char* const* argv, const std::function<int()>& run);

}  // namespace fallen
