// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/tool.hpp"

#include <CLI/CLI.hpp>

#include "fallen/service/command_line.hpp"

namespace fallen {

std::unique_ptr<CLI::App> MakeToolParser(const std::string& name, const std::string& description) {
  auto parser = std::make_unique<CLI::App>();
  AddStandardFlags(*parser, name, description);
  return parser;
}

int RunTool(CLI::App& parser, int argc, const char* const* argv, const std::function<int()>& run) {
  return RunCommandLine(parser, argc, argv, run);
}

}  // namespace fallen
