// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/service_chain.hpp"

#include <gtest/gtest.h>

namespace fallen::testing_support {
namespace {

using std::chrono::seconds;

// Generous: the machine may be busy with other tests.
constexpr seconds kStartTimeout{30};
constexpr seconds kResultTimeout{30};
constexpr seconds kRunTimeout{120};
/// In which lcm-logger, which does not say when it is ready, has subscribed.
constexpr std::chrono::milliseconds kJoinTime{500};

}  // namespace

ServiceChain::ServiceChain(const std::filesystem::path& model,
                           const std::filesystem::path& configuration, Pace pace)
    : url_(EnterPrivateNetwork()),
      model_(model),
      configuration_(configuration),
      pace_(pace),
      recorder_(url_, pace == Pace::kLive ? "STATUS_.*" : ".*") {}

void ServiceChain::Start(const Stage& stage, const std::vector<std::string>& more_arguments) {
  std::vector<std::string> command{Program("fallen-" + stage.service), "--lcm-url", url_};
  if (pace_ == Pace::kLossless) command.push_back("--lossless");
  if (stage.needs_model) command.insert(command.end(), {"--model", model_.string()});
  if (!configuration_.empty()) command.insert(command.end(), {"--config", configuration_.string()});
  command.insert(command.end(), more_arguments.begin(), more_arguments.end());
  const auto started =
      processes_.emplace(stage.service, ChildProcess(command, folder_.path())).first;
  // Its own, not the last of one before it.
  const bool is_up = recorder_.HandleUntil(
      [&] { return recorder_.Status(stage.service).pid == started->second.pid(); }, kStartTimeout);
  EXPECT_TRUE(is_up) << stage.service << ": " << process(stage.service).StandardError();
}

void ServiceChain::StartAll() {
  for (const Stage& stage : kStages) Start(stage);
}

void ServiceChain::Run(const std::vector<std::string>& command) {
  ChildProcess program(command, folder_.path());
  std::optional<int> exit_status;
  const bool has_ended = recorder_.HandleUntil(
      [&] { return (exit_status = program.WaitForExit(std::chrono::milliseconds(0))).has_value(); },
      kRunTimeout);
  EXPECT_TRUE(has_ended);
  EXPECT_EQ(exit_status, 0) << program.StandardError();
}

void ServiceChain::Play(const std::filesystem::path& log, const std::string& channels) {
  Run({"lcm-logplayer", "--lcm-url=" + url_, "-e", channels, log.string()});
}

bool ServiceChain::WaitForMessages(const std::string& channel, std::size_t count) {
  return recorder_.HandleUntil([&] { return recorder_.Count(channel) >= count; }, kResultTimeout);
}

ChildProcess ServiceChain::StartLogger(const std::filesystem::path& log) {
  ChildProcess logger({"lcm-logger", "-q", "-f", "--lcm-url=" + url_, log.string()},
                      folder_.path());
  recorder_.HandleFor(kJoinTime);
  return logger;
}

void ServiceChain::StopAll() {
  for (const Stage& stage : kStages) {
    const auto found = processes_.find(stage.service);
    if (found == processes_.end()) continue;
    EXPECT_EQ(found->second.Stop(), 0) << stage.service << ": " << found->second.StandardError();
  }
  processes_.clear();
}

}  // namespace fallen::testing_support
