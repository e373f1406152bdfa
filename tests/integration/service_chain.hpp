// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fallen/detection/model.hpp"
#include "tests/integration/lcm_recorder.hpp"
#include "tests/integration/private_network.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/stages.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen::testing_support {

/// Memory that a service may hold; sanitizers multiply it.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::int64_t kMaxResidentBytes = std::int64_t{1} << 40;
#else
inline constexpr std::int64_t kMaxResidentBytes = 64 << 20;
#endif

/// Services of ours as separate processes on a private network, and somebody who listens.
class ServiceChain {
 public:
  enum class Pace {
    kLossless,  ///< every frame; all that is sent is kept
    kLive,      ///< the newest frame, as on a robot; only statuses are kept
  };

  /// @param model          File for the stages that need one.
  /// @param configuration  File for all of them; empty: none.
  explicit ServiceChain(const std::filesystem::path& model,
                        const std::filesystem::path& configuration = {},
                        Pace pace = Pace::kLossless);

  /// Starts a service and waits for its first status.
  void Start(const Stage& stage, const std::vector<std::string>& more_arguments = {});
  void StartAll();

  /// Runs a program to its end while listening. Expects exit status 0.
  void Run(const std::vector<std::string>& command);

  /// Plays a log at its own speed with lcm-logplayer while listening.
  /// @param channels  Regular expression of the channels to play.
  void Play(const std::filesystem::path& log, const std::string& channels);

  /// Listens until `channel` has had so many messages.
  bool WaitForMessages(const std::string& channel, std::size_t count);

  /// Records all channels with lcm-logger from now on, until it is stopped.
  ChildProcess StartLogger(const std::filesystem::path& log);

  /// SIGTERM to all, in order, so that each still hears the one before. Expects exit status 0 of
  /// each.
  void StopAll();

  const std::string& url() const { return url_; }
  LcmRecorder& recorder() { return recorder_; }
  ChildProcess& process(const std::string& service) { return processes_.at(service); }
  void Forget(const std::string& service) { processes_.erase(service); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  const std::string url_;
  std::filesystem::path model_;
  std::filesystem::path configuration_;
  Pace pace_;
  TemporaryFolder folder_;
  LcmRecorder recorder_;
  std::map<std::string, ChildProcess> processes_;
};

}  // namespace fallen::testing_support
