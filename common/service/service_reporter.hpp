// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "fallen/messages/log_file.hpp"
#include "fallen/service/logging.hpp"
#include "fallen/service/sequence_gaps.hpp"
#include "fallen/service/timing_window.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen {

/// States of a service, as in service_status_t.
enum class ServiceState : std::int8_t {
  kStarting = service_status_t::STARTING,
  kRunning = service_status_t::RUNNING,
  kDegraded = service_status_t::DEGRADED,
  kLost = service_status_t::LOST,
  kStopping = service_status_t::STOPPING,
};

/// What a service says about itself: counters, timing and state, repeated at 1 Hz on
/// STATUS_<SERVICE>; and the one way out for its results, so that what is counted is what was sent.
///
/// Thread-safe: one mutex for publishing, one for the counters.
class ServiceReporter {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param lcm      Must outlive this.
  /// @param service  As in "fallen-<service>".
  ServiceReporter(lcm::LCM& lcm, const std::string& service, const std::string& camera);

  /// An input frame that could be decoded.
  /// @param camera  Whose: each counts its own frames.
  void CountReceived(std::int64_t utime, std::int64_t seq, const std::string& camera = {});
  /// An input that could not be used, and why.
  void CountDamaged(const std::string& reason);
  /// The same for a frame that could not even be decoded: its seq is missing, but it is not lost.
  void CountDamagedFrame(const std::string& reason);
  void CountLate(std::int64_t frames, const std::string& reason);
  void CountSkipped();

  /// Sends a result that took `milliseconds` and counts it.
  template <class Message>
  void PublishResult(const std::string& channel, const Message& message, double milliseconds) {
    CountPublished(Publish(channel, EncodeMessage(message)), milliseconds);
  }

  /// Sends something that is no result. @return false if it could not be sent.
  bool Publish(const std::string& channel, const std::vector<std::uint8_t>& bytes);

  /// The state from now on, and a line for people ("" for nothing to say). Says so in the log when
  /// it changes. kRunning shows as STARTING before the first input, and as DEGRADED while what
  /// comes in can not be used.
  void SetState(ServiceState state, const std::string& text);

  service_status_t Status() const;
  void PublishStatus();
  /// Publishes the status if the last is a second old. @return Time until the next is due.
  std::chrono::milliseconds PublishStatusIfDue();

 private:
  void CountPublished(bool sent, double milliseconds);

  lcm::LCM& lcm_;
  const std::string status_channel_;
  std::mutex publish_mutex_;

  mutable std::mutex mutex_;  // guards all below but the last
  service_status_t counts_{};
  ServiceState state_ = ServiceState::kStarting;
  std::string text_;
  std::string newest_damage_;
  bool is_newest_damaged_ = false;
  std::int64_t damaged_since_received_ = 0;
  std::int64_t damaged_in_gaps_ = 0;
  std::map<std::string, SequenceGaps> gaps_;  // by camera
  std::int64_t missing_ = 0;
  TimingWindow timing_;
  RepeatedWarnings warnings_;
  Clock::time_point next_status_{};  // of the thread that runs the loop
};

/// Memory of this process that is resident [bytes]; 0 if the system does not tell.
std::int64_t ResidentBytes();

}  // namespace fallen
