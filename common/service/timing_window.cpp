// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/timing_window.hpp"

#include <algorithm>
#include <cmath>

namespace fallen {
namespace {

// Below it a rate over so short a time says nothing: the first results count as over one second.
constexpr double kMinRateWindow_s = 1.0;

}  // namespace

void TimingWindow::Add(double milliseconds, Clock::time_point now) {
  if (ready_.empty() && milliseconds_.empty()) first_ = now;
  milliseconds_.push_back(milliseconds);
  if (milliseconds_.size() > kTimes) milliseconds_.pop_front();
  ready_.push_back(now);
  while (now - ready_.front() > kRateWindow) ready_.pop_front();
}

double TimingWindow::Quantile(double share) const {
  if (milliseconds_.empty()) return 0;
  std::vector<double> sorted(milliseconds_.begin(), milliseconds_.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(rank > 0 ? rank - 1 : 0);
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

double TimingWindow::RateHz(Clock::time_point now) const {
  const auto recent = std::count_if(ready_.begin(), ready_.end(), [&](Clock::time_point time) {
    return now - time <= kRateWindow;
  });
  if (recent == 0) return 0;
  const double since_first_s = std::chrono::duration<double>(now - first_).count();
  const double window_s = std::clamp(since_first_s, kMinRateWindow_s,
                                     std::chrono::duration<double>(kRateWindow).count());
  return static_cast<double>(recent) / window_s;
}

}  // namespace fallen
