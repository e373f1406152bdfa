// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/evaluation/frame_outcome.hpp"

/// Detection error trade-off: miss rate against false positives per frame (the paper, Fig. 5).
///
/// [Dollar12] Dollar, Wojek, Schiele, Perona: Pedestrian detection: an evaluation of the state of
/// the
///            art. PAMI 34(4), 2012. (log-average miss rate)
namespace fallen {

/// One working point: what happens if hypotheses from `min_score` on are accepted.
struct OperatingPoint {
  double min_score = 0;
  std::int64_t true_positives = 0;
  std::int64_t false_positives = 0;
  double false_positives_per_frame = 0;
  double miss_rate = 1;
};

/// The curve, from the strictest threshold (nothing accepted) to the most lenient.
struct DetectionErrorTradeoff {
  std::int64_t frames = 0;
  std::int64_t positives = 0;
  std::vector<OperatingPoint> points;

  /// Lowest miss rate with at most `false_positives_per_frame`; NaN without positives.
  double MissRateAt(double false_positives_per_frame) const;

  /// The working point of a given threshold.
  OperatingPoint AtThreshold(double min_score) const;

  /// Geometric mean of the miss rates at nine rates from 10^-2 to 10^0, evenly spaced in the
  /// logarithm [Dollar12]. A miss rate of zero counts as half a miss, since its logarithm has no
  /// bound. NaN without positives.
  double LogAverageMissRate() const;
};

/// @param outcomes  One for each frame, in any order.
DetectionErrorTradeoff ComputeTradeoff(std::span<const FrameOutcome> outcomes);

}  // namespace fallen
