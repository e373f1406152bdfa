// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fallen::testing_support {

/// A program that runs beside the test; killed with it.
class ChildProcess {
 public:
  /// @param command  Program, sought in PATH if it has no slash, and its arguments.
  /// @param folder   Takes its stdout and stderr, as files.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& folder);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess(const ChildProcess&) = delete;

  void Signal(int signal) const;
  /// Exit status (128 + signal, if it died of one); nothing if it still runs after `timeout`.
  std::optional<int> WaitForExit(std::chrono::milliseconds timeout);
  /// SIGTERM, then WaitForExit.
  std::optional<int> Stop(std::chrono::milliseconds timeout = std::chrono::seconds(20));

  pid_t pid() const { return pid_; }
  std::string StandardOutput() const;
  std::string StandardError() const;

 private:
  pid_t pid_ = -1;
  std::filesystem::path output_;
  std::filesystem::path error_;
};

/// Path of a program of ours.
std::string Program(const std::string& name);

}  // namespace fallen::testing_support
