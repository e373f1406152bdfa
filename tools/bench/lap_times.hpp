// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <vector>

namespace fallen {

/// The time of every iteration, because a mean hides what a robot waits for.
class LapTimes {
 public:
  void Start() { start_ = Clock::now(); }
  void Stop() {
    milliseconds_.push_back(
        std::chrono::duration<double, std::milli>(Clock::now() - start_).count());
  }
  /// Adds a time that was measured elsewhere [ms].
  void Add(double milliseconds) { milliseconds_.push_back(milliseconds); }

  /// Middle value; 0 without any.
  double Median() const { return Quantile(0.5); }
  double Quantile(double share) const;

  /// Sets the counters `median_ms` and `p95_ms`.
  void Report(benchmark::State& state) const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  std::vector<double> milliseconds_;
};

}  // namespace fallen
