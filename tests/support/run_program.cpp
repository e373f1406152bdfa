// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/run_program.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {

ProgramOutcome RunCommand(const std::vector<std::string>& command,
                          std::chrono::milliseconds timeout) {
  const TemporaryFolder folder;
  testing_support::ChildProcess child(command, folder.path());
  const int status = child.WaitForExit(timeout).value_or(-1);
  return {status, child.StandardOutput(), child.StandardError()};
}

ProgramOutcome RunProgram(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{testing_support::Program(program)};
  if (!std::filesystem::exists(command[0]))
    throw std::runtime_error(command[0] + " has not been built");
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunCommand(command);
}

ProgramOutcome RunShell(const std::string& script) { return RunCommand({"sh", "-c", script}); }

bool IsOneLine(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

}  // namespace fallen
