// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/feature_network_training.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace fallen {
namespace {

struct Samples {
  FeatureMatrix features;
  std::vector<std::int8_t> labels;
  std::vector<float> weights;
};

// Inside of a ring in the first two of six features is +1: no line parts the classes.
Samples Ring(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Samples samples{FeatureMatrix(count, 6), {}, {}};
  for (int i = 0; i < count; ++i) {
    for (int f = 0; f < 6; ++f) samples.features(i, f) = uniform(random);
    samples.labels.push_back(samples.features.row(i).head(2).norm() < 0.75F ? 1 : -1);
    samples.weights.push_back(0.5F + std::abs(uniform(random)));
  }
  return samples;
}

double CorrectShare(const FeatureNetwork& network, const Samples& samples) {
  std::vector<float> scores;
  NetworkScorer(network).Score(samples.features, scores);
  double correct = 0;
  for (std::size_t i = 0; i < scores.size(); ++i)
    correct += (scores[i] > 0) == (samples.labels[i] > 0);
  return correct / static_cast<double>(scores.size());
}

// The weighted mean of log(1 + exp(-y F(x))) by the definition, with double's precision.
double LossOf(const FeatureNetwork& network, const Samples& samples) {
  double loss = 0, weight = 0;
  for (Eigen::Index row = 0; row < samples.features.rows(); ++row) {
    Eigen::RowVectorXd values = network.Standardize(samples.features.row(row)).cast<double>();
    for (const FeatureNetwork::Layer& layer : network.layers) {
      values = (values * layer.weights.cast<double>() + layer.bias.cast<double>()).eval();
      if (layer.bias.size() > 1) values = values.cwiseMax(0.0).eval();
    }
    const auto i = static_cast<std::size_t>(row);
    loss += samples.weights[i] * std::log1p(std::exp(-samples.labels[i] * values[0]));
    weight += samples.weights[i];
  }
  return loss / weight;
}

TEST(TrainFeatureNetwork, LearnsWhatNoLineParts) {
  const Samples learnt = Ring(2000, 1), unseen = Ring(2000, 2);
  const NetworkTrainingConfig config{.epochs = 40,
                                     .first_units = 32,
                                     .second_units = 16,
                                     .batch_size = 50,
                                     .learning_rate = 0.01,
                                     .dropout = 0.1};
  const FeatureNetwork network =
      TrainFeatureNetwork(learnt.features, learnt.labels, learnt.weights, config);
  EXPECT_NO_THROW(network.Validate());
  EXPECT_GT(CorrectShare(network, unseen), 0.93);
}

// The first step of Adam moves every weight by the learning rate against its gradient's sign.
TEST(TrainFeatureNetwork, StepsDownTheGradient) {
  const Samples samples = Ring(40, 3);
  NetworkTrainingConfig config{.epochs = 1,
                               .first_units = 5,
                               .second_units = 4,
                               .batch_size = 40,
                               .learning_rate = 1e-30,
                               .dropout = 0,
                               .weight_decay = 0};
  FeatureNetwork start =
      TrainFeatureNetwork(samples.features, samples.labels, samples.weights, config);
  constexpr float kRate = 1e-3F;
  config.learning_rate = kRate;
  const FeatureNetwork stepped =
      TrainFeatureNetwork(samples.features, samples.labels, samples.weights, config);
  int compared = 0;
  const auto compare = [&](float& value, float after) {
    const float before = value;
    constexpr float kProbe = 1e-3F;
    value = before + kProbe;
    const double above = LossOf(start, samples);
    value = before - kProbe;
    const double slope = (above - LossOf(start, samples)) / (2 * kProbe);
    value = before;
    if (std::abs(slope) < 1e-3) return;  // too flat, or at a unit's bend
    EXPECT_NEAR(after - before, slope > 0 ? -kRate : kRate, kRate * 0.02);
    ++compared;
  };
  for (std::size_t l = 0; l < 3; ++l) {
    FeatureNetwork::Layer& layer = start.layers[l];
    for (Eigen::Index i = 0; i < layer.weights.size(); ++i)
      compare(layer.weights.data()[i], stepped.layers[l].weights.data()[i]);
    for (Eigen::Index i = 0; i < layer.bias.size(); ++i)
      compare(layer.bias[i], stepped.layers[l].bias[i]);
  }
  EXPECT_GT(compared, 30);  // of 64
}

TEST(TrainFeatureNetwork, FindsTheLogOddsOfTheWeights) {
  // At 1 persons weigh three times as much as others, at -1 a third.
  const Samples samples{Eigen::Vector4f(1, 1, -1, -1), {1, -1, 1, -1}, {3, 1, 1, 3}};
  const NetworkTrainingConfig config{.epochs = 3000,
                                     .first_units = 8,
                                     .second_units = 8,
                                     .batch_size = 4,
                                     .learning_rate = 0.01,
                                     .dropout = 0,
                                     .weight_decay = 0};
  std::vector<float> scores;
  NetworkScorer(TrainFeatureNetwork(samples.features, samples.labels, samples.weights, config))
      .Score(samples.features, scores);
  EXPECT_NEAR(scores[0], std::tanh(std::log(3) / 16), 1e-3);
  EXPECT_NEAR(scores[2], -std::tanh(std::log(3) / 16), 1e-3);
}

TEST(TrainFeatureNetwork, IsTheSameWithTheSameSeed) {
  const Samples samples = Ring(300, 4);
  NetworkTrainingConfig config{.epochs = 2, .first_units = 8, .second_units = 4};
  const auto train = [&] {
    return TrainFeatureNetwork(samples.features, samples.labels, samples.weights, config);
  };
  const FeatureNetwork one = train();
  EXPECT_EQ(train(), one);
  config.seed = 2;
  EXPECT_NE(train(), one);
}

TEST(TrainFeatureNetwork, AFeatureThatNeverVariesSaysNothing) {
  Samples samples = Ring(300, 5);
  samples.features.col(3).setConstant(7);
  const FeatureNetwork network =
      TrainFeatureNetwork(samples.features, samples.labels, samples.weights,
                          {.epochs = 1, .first_units = 8, .second_units = 4});
  EXPECT_EQ(network.scale[3], 0);
  std::vector<float> scores, with_another;
  NetworkScorer(network).Score(samples.features, scores);
  samples.features.col(3).setConstant(-100);
  NetworkScorer(network).Score(samples.features, with_another);
  EXPECT_EQ(with_another, scores);
}

TEST(TrainFeatureNetwork, TellsHowFarItIs) {
  const Samples samples = Ring(500, 6);
  std::vector<NetworkTrainingProgress> told;
  TrainFeatureNetwork(samples.features, samples.labels, {},
                      {.epochs = 30,
                       .first_units = 16,
                       .second_units = 8,
                       .batch_size = 100,
                       .learning_rate = 0.01,
                       .dropout = 0},
                      [&](const NetworkTrainingProgress& progress) { told.push_back(progress); });
  ASSERT_EQ(told.size(), 150U);
  EXPECT_EQ(told.back().done, 1);
  EXPECT_NEAR(told[74].done, 0.5, 1e-9);
  EXPECT_LT(told.back().loss, told.front().loss / 2);
}

TEST(TrainFeatureNetwork, RefusesWhatCannotBeLearntFrom) {
  const Samples good = Ring(20, 7);
  const auto refuses = [&](auto&& change, NetworkTrainingConfig config = {.epochs = 1}) {
    Samples samples = good;
    change(samples, config);
    EXPECT_THROW(TrainFeatureNetwork(samples.features, samples.labels, samples.weights, config),
                 std::invalid_argument);
  };
  refuses([](auto& s, auto&) { s.features(3, 3) = std::numeric_limits<float>::quiet_NaN(); });
  refuses([](auto& s, auto&) { s.labels.pop_back(); });
  refuses([](auto& s, auto&) { s.weights.pop_back(); });
  refuses([](auto& s, auto&) { s.weights[2] = 0; });
  refuses([](auto& s, auto&) { s.labels.assign(20, 1); });
  refuses([](auto& s, auto&) { s.labels[4] = 0; });
  refuses([](auto&, auto& c) { c.epochs = -1; });
  refuses([](auto&, auto& c) { c.first_units = 0; });
  refuses([](auto&, auto& c) { c.second_units = 0; });
  refuses([](auto&, auto& c) { c.batch_size = 0; });
  refuses([](auto&, auto& c) { c.learning_rate = 0; });
  refuses([](auto&, auto& c) { c.dropout = 1; });
  refuses([](auto&, auto& c) { c.weight_decay = -1; });
  EXPECT_TRUE(TrainFeatureNetwork(good.features, good.labels, {}, {.epochs = 0}).empty());
}

}  // namespace
}  // namespace fallen
