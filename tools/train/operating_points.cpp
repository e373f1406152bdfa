// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/operating_points.hpp"

namespace fallen {
namespace {

// Rates at which the operating points are kept: what a user may ask for.
constexpr double kRates[] = {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};

}  // namespace

std::vector<Calibration::OperatingPoint> OperatingPointsOf(const DetectionErrorTradeoff& tradeoff) {
  std::vector<Calibration::OperatingPoint> kept;
  for (const double rate : kRates) {
    const OperatingPoint* best = nullptr;
    for (const OperatingPoint& point : tradeoff.points)
      if (point.false_positives_per_frame <= rate && point.min_score <= 1) best = &point;
    if (!best) continue;
    if (kept.empty() || kept.back().min_probability < best->min_score)
      kept.push_back({best->min_score, best->false_positives_per_frame, best->miss_rate});
  }
  return kept;
}

}  // namespace fallen
