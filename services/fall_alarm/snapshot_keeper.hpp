// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <lcm/lcm-cpp.hpp>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "services/fall_alarm/alarm_history.hpp"

namespace fallen {

/// Remembers the last messages of the channels that show what an alarm was about, as they came, so
/// that the frame that raises it can be kept: depth image, map and decision of that frame, and the
/// robot's pose before it.
///
/// Messages are not decoded: a camera at 30 Hz costs a copy each. Thread-safe.
class SnapshotKeeper {
 public:
  /// @param lcm        Must outlive this.
  /// @param max_bytes  What is remembered, over all channels: the oldest goes first. The default is
  ///                   2 s of a camera of 640 x 480 at 30 Hz; an alarm asks within a frame or two.
  explicit SnapshotKeeper(lcm::LCM& lcm, std::size_t max_bytes = std::size_t{32} << 20);
  ~SnapshotKeeper();
  SnapshotKeeper(const SnapshotKeeper&) = delete;
  SnapshotKeeper& operator=(const SnapshotKeeper&) = delete;

  /// What is remembered about the frame of `camera` at `utime`; nothing if nothing is.
  std::optional<AlarmSnapshot> Take(const std::string& camera, std::int64_t utime) const;

 private:
  struct Message {
    std::string channel;
    std::int64_t utime;
    std::vector<std::uint8_t> bytes;
  };
  void Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept;

  lcm::LCM& lcm_;
  const std::size_t max_bytes_;
  lcm::Subscription* subscription_ = nullptr;
  mutable std::mutex mutex_;
  std::deque<Message> messages_;
  std::size_t bytes_ = 0;
};

}  // namespace fallen
