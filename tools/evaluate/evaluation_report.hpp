// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fallen/evaluation/bootstrap.hpp"
#include "fallen/evaluation/detection_error_tradeoff.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"

namespace fallen {

/// The curve over all frames of the sequences.
DetectionErrorTradeoff CurveOf(const std::vector<SequenceOutcome>& sequences);

/// Figures of one detector: the curve's summary, and what happens at `min_probability`.
nlohmann::json FiguresJson(const DetectionErrorTradeoff& curve, double min_probability);

/// The same over sequences, with the intervals of the rates: `"intervals": {"confidence": …,
/// "miss_rate_at_0.01_fppf": [low, high], …}`.
nlohmann::json FiguresJson(const std::vector<SequenceOutcome>& sequences, double min_probability,
                           const BootstrapConfig& bootstrap);

/// For every kind of thing that is in the scene of a sequence: `{"dog": {"sequences": …, "frames":
/// …, "false_positives_per_frame": …, "flagged_frames": …}}`, the last the share of frames with a
/// false positive at `min_probability`. A person on a sofa is never to be flagged: the recordings
/// of such persons hold nobody else.
nlohmann::json KindsJson(const std::vector<SequenceOutcome>& sequences, double min_probability);

/// Figures of every sequence by itself.
nlohmann::json SequencesJson(const std::vector<SequenceOutcome>& sequences, double min_probability);

/// A named curve of a plot.
struct NamedCurve {
  std::string name;
  DetectionErrorTradeoff curve;
};

/// Draws the curves, both axes logarithmic, with gnuplot.
/// @param path  Ends in .svg or .png.
/// @throws std::runtime_error if gnuplot is missing or fails.
void PlotCurves(const std::vector<NamedCurve>& curves, const std::filesystem::path& path);

}  // namespace fallen
