// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/support/temporary_folder.hpp"

namespace fallen::testing_support {
namespace {

constexpr std::chrono::milliseconds kPollInterval{5};
constexpr int kDiedOfSignal = 128;  // as shells say it

void Redirect(const std::filesystem::path& path, int descriptor) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file >= 0) dup2(file, descriptor);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& folder) {
  static std::atomic<int> count = 0;
  const std::string stem =
      std::filesystem::path(command.at(0)).filename().string() + "-" + std::to_string(count++);
  output_ = folder / (stem + ".out");
  error_ = folder / (stem + ".err");
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);

  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ > 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that crashes leaves nothing behind
  Redirect(output_, STDOUT_FILENO);
  Redirect(error_, STDERR_FILENO);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      output_(std::move(other.output_)),
      error_(std::move(other.error_)) {}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void ChildProcess::Signal(int signal) const {
  if (pid_ > 0) kill(pid_, signal);
}

std::optional<int> ChildProcess::WaitForExit(std::chrono::milliseconds timeout) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  do {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      pid_ = -1;
      return WIFEXITED(status) ? WEXITSTATUS(status) : kDiedOfSignal + WTERMSIG(status);
    }
    std::this_thread::sleep_for(kPollInterval);
  } while (std::chrono::steady_clock::now() < deadline);
  return std::nullopt;
}

std::optional<int> ChildProcess::Stop(std::chrono::milliseconds timeout) {
  Signal(SIGTERM);
  return WaitForExit(timeout);
}

std::string ChildProcess::StandardOutput() const { return ReadText(output_); }

std::string ChildProcess::StandardError() const { return ReadText(error_); }

std::string Program(const std::string& name) { return std::string(FALLEN_BIN_DIR) + "/" + name; }

}  // namespace fallen::testing_support
