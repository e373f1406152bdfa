// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/command_line.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <optional>

#include "fallen/service/version.hpp"

namespace fallen {
namespace {

int ReportWrongCall(const std::string& program, const std::string& text) {
  std::string line = program + ": " + text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << line << std::endl;
  return kExitWrongCall;
}

/// Nothing to go on; else the status to exit with.
std::optional<int> Parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& request) {  // --help, --version
    return app.exit(request);
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> extras = app.remaining();
    const std::string first = extras.empty() ? "arguments" : extras.front();
    const char* what = first.rfind('-', 0) == 0 ? ": unknown option" : ": unexpected argument";
    return ReportWrongCall(app.get_name(), first + what + ", see --help");
  } catch (const CLI::ParseError& error) {
    return ReportWrongCall(app.get_name(), std::string(error.what()) + ", see --help");
  }
}

}  // namespace

void AddStandardFlags(CLI::App& app, const std::string& program, const std::string& description) {
  app.name(program);
  app.description(description);
  app.set_help_flag("--help", "Say how to call this program");
  app.set_version_flag("--version", program + " " + Version(), "Say which version this is");
}

int RunCommandLine(CLI::App& app, int argc, const char* const* argv,
                   const std::function<int()>& run) {
  if (const std::optional<int> status = Parse(app, argc, argv)) return *status;
  try {
    return run();
  } catch (const std::exception& error) {
    return ReportWrongCall(app.get_name(), error.what());
  }
}

}  // namespace fallen
