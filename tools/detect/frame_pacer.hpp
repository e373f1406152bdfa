// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "fallen/detection/frame.hpp"

namespace fallen {

/// Plays frames at the pace of their recording and drops those that come too late, newest first, as
/// the live services do.
class FramePacer {
 public:
  using Clock = std::chrono::steady_clock;

  /// Where frames come from, what time it is, and how to wait: the latter two for tests.
  struct Source {
    std::function<std::optional<Frame>()> next;
    std::function<Clock::time_point()> now;
    std::function<void(Clock::time_point)> sleep_until;
  };
  explicit FramePacer(std::function<std::optional<Frame>()> next);
  explicit FramePacer(Source source);

  /// The newest frame whose time has come, or the next one once it has; nothing at the end.
  std::optional<Frame> Next();

  std::int64_t dropped() const { return dropped_; }

 private:
  struct Timed {
    Frame frame;
    Clock::time_point due;
  };
  struct Previous {
    std::int64_t utime;
    Clock::time_point due;
  };
  std::optional<Timed> Fetch();

  Source source_;
  std::optional<Timed> pending_;
  std::optional<Previous> previous_;
  std::int64_t dropped_ = 0;
};

}  // namespace fallen
