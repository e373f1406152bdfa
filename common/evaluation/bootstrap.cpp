// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

void Check(std::size_t sequences, const BootstrapConfig& config) {
  if (sequences == 0) throw std::invalid_argument("bootstrap: got no sequences, expected one");
  if (config.resamples < 1)
    throw std::invalid_argument("bootstrap: resamples is " + std::to_string(config.resamples) +
                                ", must be >= 1");
  if (!(config.confidence > 0 && config.confidence < 1))
    throw std::invalid_argument("bootstrap: confidence is " + std::to_string(config.confidence) +
                                ", must be in (0, 1)");
}

/// Value below which `share` of the sorted values lie, interpolated between neighbours.
double Quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Interval PercentileInterval(std::vector<double> values, double confidence) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown};
  }
  std::sort(values.begin(), values.end());
  return {Quantile(values, (1 - confidence) / 2), Quantile(values, (1 + confidence) / 2)};
}

}  // namespace

std::vector<Interval> BootstrapIntervals(std::span<const std::vector<FrameOutcome>> sequences,
                                         const Figures& figures, const BootstrapConfig& config) {
  Check(sequences.size(), config);
  std::mt19937_64 random(config.seed);
  std::vector<std::vector<double>> values;  // figure by figure
  std::vector<FrameOutcome> frames;
  for (int resample = 0; resample < config.resamples; ++resample) {
    frames.clear();
    for (std::size_t i = 0; i < sequences.size(); ++i) {
      const std::vector<FrameOutcome>& drawn = sequences[random() % sequences.size()];
      frames.insert(frames.end(), drawn.begin(), drawn.end());
    }
    const std::vector<double> drawn_figures = figures(frames);
    values.resize(drawn_figures.size());
    for (std::size_t k = 0; k < drawn_figures.size(); ++k) values[k].push_back(drawn_figures[k]);
  }
  std::vector<Interval> intervals;
  for (std::vector<double>& figure : values)
    intervals.push_back(PercentileInterval(std::move(figure), config.confidence));
  return intervals;
}

}  // namespace fallen
