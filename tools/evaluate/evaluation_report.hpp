// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fallen/evaluation/detection_error_tradeoff.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"

namespace fallen {

/// Figures of one detector: the curve's summary, and what happens at `min_probability`.
nlohmann::json FiguresJson(const DetectionErrorTradeoff& curve, double min_probability);

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
