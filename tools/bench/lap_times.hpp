// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

namespace fallen {

/// The time of every iteration, because a mean hides what a robot waits for.
///
/// Time in which this thread had a core: what one core needs, whatever else the machine does.
class LapTimes {
 public:
  void Start() { start_ms_ = Now(); }
  void Stop() { milliseconds_.push_back(Now() - start_ms_); }
  /// Adds a time that was measured elsewhere [ms].
  void Add(double milliseconds) { milliseconds_.push_back(milliseconds); }

  /// Middle value; 0 without any.
  double Median() const { return Quantile(0.5); }
  double Quantile(double share) const;

  /// Sets the counters `median_ms` and `p95_ms`.
  void Report(benchmark::State& state) const;

 private:
  static double Now();

  double start_ms_ = 0;
  std::vector<double> milliseconds_;
};

}  // namespace fallen
