// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/gate_training.hpp"

#include <algorithm>
#include <cstddef>

namespace fallen {
namespace {

auto ShapesOf(const CellSamples& samples) {
  return samples.features.rightCols<kShapeFeatureCount>();
}

// The score that the wanted share of persons reaches.
double ScoreReachedBy(double share, const CellSamples& samples, const std::vector<float>& scores) {
  std::vector<float> of_persons;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (samples.labels[i] > 0) of_persons.push_back(scores[i]);
  const auto below =
      static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(of_persons.size()));
  std::nth_element(of_persons.begin(), of_persons.begin() + below, of_persons.end());
  return static_cast<double>(of_persons[below]);
}

// What the trees say on average of the cells that are turned away.
double MeanScoreTurnedAway(const CellGate& gate, const std::vector<float>& gate_scores,
                           const std::vector<float>& scores) {
  double sum = 0;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (gate.Passes(gate_scores[i])) continue;
    sum += static_cast<double>(scores[i]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : -1;
}

}  // namespace

CellGate TrainCellGate(const CellSamples& samples, const BoostedTrees& trees,
                       const TrainingConfig& config, int jobs, const TrainingProgress& progress) {
  CellGate gate;
  const FeatureMatrix shapes = ShapesOf(samples);
  gate.trees = TrainBoostedTrees(
      shapes, samples.labels, samples.weights, config.gate_boosting,
      [&](const BoostingProgress& state) {
        progress("gate", static_cast<double>(state.round) / config.gate_boosting.rounds);
      },
      jobs);
  const std::vector<float> scores = PredictScores(gate.trees, shapes);
  gate.min_score = ScoreReachedBy(config.sampling.gate_person_share, samples, scores);
  gate.turned_away_score =
      MeanScoreTurnedAway(gate, scores, PredictScores(trees, samples.features));
  return gate;
}

GateFigures MeasureGate(const CellGate& gate, const CellSamples& samples) {
  if (gate.is_open()) return {};
  const std::vector<float> scores = PredictScores(gate.trees, ShapesOf(samples));
  std::int64_t persons = 0, persons_passed = 0, others = 0, others_passed = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const bool is_person = samples.labels[i] > 0;
    ++(is_person ? persons : others);
    if (gate.Passes(scores[i])) ++(is_person ? persons_passed : others_passed);
  }
  return {static_cast<double>(persons_passed) / static_cast<double>(persons),
          static_cast<double>(others_passed) / static_cast<double>(others)};
}

}  // namespace fallen
