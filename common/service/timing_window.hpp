// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <vector>

namespace fallen {

/// Time to handle a frame and results per second, over the recent past. Not thread-safe.
class TimingWindow {
 public:
  using Clock = std::chrono::steady_clock;

  /// Adds a result that took `milliseconds` and was ready at `now`.
  void Add(double milliseconds, Clock::time_point now);

  /// Quantile (nearest rank) of the times of the last 256 results [ms]; 0 without any.
  double Quantile(double share) const;
  /// Results per second over the last 5 s before `now`, or since the first result if that is less.
  double RateHz(Clock::time_point now) const;

 private:
  static constexpr std::size_t kTimes = 256;  // as service_status_t says
  static constexpr std::chrono::seconds kRateWindow{5};
  std::deque<double> milliseconds_;
  std::deque<Clock::time_point> ready_;
  Clock::time_point first_;
};

}  // namespace fallen
