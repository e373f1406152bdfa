// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/detection_error_tradeoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fallen {
namespace {

struct ScoredEvent {
  double score;
  bool is_hit;
};

OperatingPoint MakePoint(const DetectionErrorTradeoff& curve, double min_score,
                         std::int64_t true_positives, std::int64_t false_positives) {
  OperatingPoint point;
  point.min_score = min_score;
  point.true_positives = true_positives;
  point.false_positives = false_positives;
  if (curve.frames > 0)
    point.false_positives_per_frame =
        static_cast<double>(false_positives) / static_cast<double>(curve.frames);
  point.miss_rate = curve.positives > 0 ? 1 - static_cast<double>(true_positives) /
                                                  static_cast<double>(curve.positives)
                                        : std::numeric_limits<double>::quiet_NaN();
  return point;
}

}  // namespace

double DetectionErrorTradeoff::MissRateAt(double false_positives_per_frame) const {
  // Along the curve both counts only grow, so the last point that still qualifies is the best.
  double miss_rate = positives > 0 ? 1 : std::numeric_limits<double>::quiet_NaN();
  for (const OperatingPoint& point : points)
    if (point.false_positives_per_frame <= false_positives_per_frame) miss_rate = point.miss_rate;
  return miss_rate;
}

OperatingPoint DetectionErrorTradeoff::AtThreshold(double min_score) const {
  OperatingPoint result = points.front();
  for (const OperatingPoint& point : points)
    if (point.min_score >= min_score) result = point;
  return result;
}

double DetectionErrorTradeoff::LogAverageMissRate() const {
  if (positives == 0) return std::numeric_limits<double>::quiet_NaN();
  constexpr int kRates = 9;  // [Dollar12] Sec. 3.2
  const double half_a_miss = 0.5 / static_cast<double>(positives);
  double sum = 0;
  for (int i = 0; i < kRates; ++i) {
    const double rate = std::pow(10.0, -2 + 2.0 * i / (kRates - 1));
    sum += std::log(std::max(half_a_miss, MissRateAt(rate)));
  }
  return std::exp(sum / kRates);
}

DetectionErrorTradeoff ComputeTradeoff(std::span<const FrameOutcome> outcomes) {
  DetectionErrorTradeoff curve;
  curve.frames = static_cast<std::int64_t>(outcomes.size());
  std::vector<ScoredEvent> events;
  for (const FrameOutcome& outcome : outcomes) {
    if (outcome.is_positive) ++curve.positives;
    if (outcome.hit_score) events.push_back({*outcome.hit_score, true});
    for (const double score : outcome.false_scores) events.push_back({score, false});
  }
  std::sort(events.begin(), events.end(),
            [](const ScoredEvent& a, const ScoredEvent& b) { return a.score > b.score; });

  curve.points.push_back(MakePoint(curve, std::numeric_limits<double>::infinity(), 0, 0));
  std::int64_t true_positives = 0;
  std::int64_t false_positives = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    ++(events[i].is_hit ? true_positives : false_positives);
    const bool score_ends = i + 1 == events.size() || events[i + 1].score != events[i].score;
    if (score_ends)
      curve.points.push_back(MakePoint(curve, events[i].score, true_positives, false_positives));
  }
  return curve;
}

}  // namespace fallen
