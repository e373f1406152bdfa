// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/tool.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace fallen {
namespace {

int Fail(const CLI::App& parser, const std::string& message) {
  std::cerr << parser.get_name() << ": " << OnOneLine(message) << std::endl;
  return kExitBadInput;
}

}  // namespace

std::unique_ptr<CLI::App> MakeToolParser(const std::string& name, const std::string& description) {
  auto parser = std::make_unique<CLI::App>(description, name);
  parser->set_version_flag("--version", name + " " + FALLEN_VERSION);
  return parser;
}

int RunTool(CLI::App& parser, int argc, const char* const* argv, const std::function<int()>& run) {
  try {
    parser.parse(argc, argv);
  } catch (const CLI::Success& wanted) {
    return parser.exit(wanted);  // --help and --version
  } catch (const CLI::ParseError& error) {
    return Fail(parser, std::string("command line: ") + error.what() + ", see --help");
  }
  try {
    return run();
  } catch (const std::exception& error) {
    return Fail(parser, error.what());
  }
}

std::string OnOneLine(std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  for (char& c : message)
    if (c == '\n' || c == '\r') c = ' ';
  return message;
}

}  // namespace fallen
