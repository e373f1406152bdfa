// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fallen/evaluation/frame_outcome.hpp"

/// How far a figure would move with other recordings of the same kind.
///
/// [Efron93] Efron, Tibshirani: An introduction to the bootstrap. Chapman & Hall 1993.
namespace fallen {

struct BootstrapConfig {
  int resamples = 1000;      ///< >= 1
  double confidence = 0.95;  ///< (0, 1)
  std::uint64_t seed = 1;
};

/// Ends of a confidence interval; NaN where the figure is not defined for any resample.
struct Interval {
  double low = 0;
  double high = 0;
};

/// Computes figures from frames.
using Figures = std::function<std::vector<double>(std::span<const FrameOutcome>)>;

/// Percentile intervals ([Efron93] Sec. 13.3) of figures over whole sequences: frames of one drive
/// show the same person and room, so sequences are what is drawn, with replacement.
/// @param figures  The same number of values at every call; those that are NaN are left out.
/// @return One interval a figure.
/// @throws std::invalid_argument for no sequences or a config out of range.
/// Deterministic: same seed, same intervals.
std::vector<Interval> BootstrapIntervals(std::span<const std::vector<FrameOutcome>> sequences,
                                         const Figures& figures,
                                         const BootstrapConfig& config = {});

}  // namespace fallen
