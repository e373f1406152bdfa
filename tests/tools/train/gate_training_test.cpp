// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/gate_training.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tools/train/cell_training.hpp"

namespace fallen {
namespace {

constexpr int kCells = 4000;

// Persons lie below 0.4 m, what else there is anywhere below 1.2 m; descriptors say nothing.
CellSamples LowPersons(std::uint32_t seed) {
  std::mt19937 random(seed);
  const int columns = CellFeatureCount({}, CellFeatureSet::kIronAndShape);
  const int height = columns - kShapeFeatureCount + 3;
  CellSamples samples;
  samples.features = FeatureMatrix::Zero(kCells, columns);
  for (int i = 0; i < kCells; ++i) {
    const bool is_person = i % 4 == 0;
    samples.features(i, height) =
        static_cast<float>(random() % 1000) * (is_person ? 0.4e-3F : 1.2e-3F);
    samples.labels.push_back(is_person ? 1 : -1);
    samples.weights.push_back(is_person ? 2.0F / kCells : 2.0F / (3 * kCells));
  }
  return samples;
}

const TrainingProgress kQuiet = [](const char*, double) {};

TEST(TrainCellGate, TurnsAwayWhatNoPersonIs) {
  const CellSamples samples = LowPersons(1);
  TrainingConfig config;
  config.sampling.gate_person_share = 0.99;
  config.boosting.rounds = 5;
  const CellModel model = TrainCellModel(samples, 0.05, config, 1, kQuiet);
  const GateFigures learnt = MeasureGate(model.gate, samples);
  EXPECT_GE(learnt.person_share, 0.99);
  EXPECT_NEAR(learnt.other_share, 1.0 / 3, 0.05);
  const GateFigures unseen = MeasureGate(model.gate, LowPersons(2));
  EXPECT_GE(unseen.person_share, 0.97);
  EXPECT_NEAR(unseen.other_share, 1.0 / 3, 0.05);

  // What is turned away is scored as the cell classifier would on average.
  const std::vector<float> gate_scores =
      PredictScores(model.gate.trees, samples.features.rightCols<kShapeFeatureCount>());
  const std::vector<float> scores = PredictScores(model.trees, samples.features);
  double sum = 0;
  int count = 0;
  for (int i = 0; i < kCells; ++i) {
    if (static_cast<double>(gate_scores[i]) >= model.gate.min_score) continue;
    sum += static_cast<double>(scores[i]);
    ++count;
  }
  ASSERT_GT(count, 1000);
  EXPECT_NEAR(model.gate.turned_away_score, sum / count, 1e-6);
  EXPECT_LT(model.gate.turned_away_score, 0);
}

TEST(TrainCellGate, IsBitIdenticalForAnyNumberOfThreads) {
  TrainingConfig config;
  config.boosting.rounds = 3;
  const CellGate one = TrainCellModel(LowPersons(1), 0.05, config, 1, kQuiet).gate;
  const CellGate two = TrainCellModel(LowPersons(1), 0.05, config, 2, kQuiet).gate;
  EXPECT_EQ(one.trees, two.trees);
  EXPECT_EQ(one.min_score, two.min_score);
  EXPECT_EQ(one.turned_away_score, two.turned_away_score);
}

TEST(TrainCellGate, StaysOpenIfEveryPersonsCellIsToPass) {
  TrainingConfig config;
  config.boosting.rounds = 3;
  config.sampling.gate_person_share = 1;
  const CellGate gate = TrainCellModel(LowPersons(1), 0.05, config, 1, kQuiet).gate;
  EXPECT_TRUE(gate.is_open());
  EXPECT_EQ(MeasureGate(gate, LowPersons(1)).other_share, 1);
}

TEST(TrainingConfig, HasNoGateWhereCellsAreDescriptorsAlone) {
  TrainingConfig config;
  config.sampling.features = CellFeatureSet::kIron;
  EXPECT_THROW(config.Validate(), std::invalid_argument);
  config.sampling.gate_person_share = 1;
  EXPECT_NO_THROW(config.Validate());
  config.sampling.gate_person_share = 0;
  EXPECT_THROW(config.Validate(), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
