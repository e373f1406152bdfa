// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/feature_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace fallen {
namespace {

FeatureMatrix RandomMatrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  return FeatureMatrix::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

// Layers of 7, 5, 3 and 1 outputs: widths that no register is as long as.
FeatureNetwork SmallNetwork() {
  std::mt19937 random(1);
  FeatureNetwork network;
  network.mean = RandomMatrix(1, 9, random);
  network.scale = RandomMatrix(1, 9, random).cwiseAbs() * 8;
  Eigen::Index inputs = 9;
  for (const Eigen::Index outputs : {7, 5, 3, 1}) {
    network.layers.push_back(
        {RandomMatrix(inputs, outputs, random), RandomMatrix(1, outputs, random)});
    inputs = outputs;
  }
  return network;
}

std::vector<float> ScoresOf(const FeatureNetwork& network, const FeatureMatrix& features) {
  std::vector<float> scores;
  NetworkScorer(network).Score(features, scores);
  return scores;
}

TEST(NetworkScorer, AgreesWithTheDefinition) {
  const FeatureNetwork network = SmallNetwork();
  network.Validate();
  std::mt19937 random(2);
  const FeatureMatrix features = RandomMatrix(50, 9, random) * 2;
  const std::vector<float> scores = ScoresOf(network, features);
  ASSERT_EQ(scores.size(), 50U);
  int cut_off = 0;
  for (Eigen::Index row = 0; row < 50; ++row) {
    std::vector<double> input;
    for (Eigen::Index i = 0; i < 9; ++i) {
      const double deviations = (features(row, i) - network.mean[i]) * network.scale[i];
      cut_off += std::abs(deviations) > 5;
      input.push_back(std::clamp(deviations, -5.0, 5.0));
    }
    for (std::size_t l = 0; l < 4; ++l) {
      const FeatureNetwork::Layer& layer = network.layers[l];
      std::vector<double> output;
      for (Eigen::Index o = 0; o < layer.bias.size(); ++o) {
        double sum = layer.bias[o];
        for (std::size_t i = 0; i < input.size(); ++i)
          sum += input[i] * layer.weights(static_cast<Eigen::Index>(i), o);
        output.push_back(l < 3 ? std::max(sum, 0.0) : sum);
      }
      input = output;
    }
    EXPECT_NEAR(scores[static_cast<std::size_t>(row)], std::tanh(input[0] / 16), 1e-5) << row;
  }
  EXPECT_GT(cut_off, 10);
}

TEST(NetworkScorer, ARowDoesNotDependOnTheOthers) {
  const FeatureNetwork network = SmallNetwork();
  std::mt19937 random(3);
  const FeatureMatrix features = RandomMatrix(20, 9, random);
  const std::vector<float> together = ScoresOf(network, features);
  NetworkScorer scorer(network);
  std::vector<float> alone;
  for (Eigen::Index row = 0; row < 20; ++row) {
    scorer.Score(features.row(row), alone);
    EXPECT_EQ(alone, std::vector<float>{together[static_cast<std::size_t>(row)]});
  }
}

TEST(NetworkScorer, RefusesWhatItCannotScore) {
  EXPECT_THROW(ScoresOf(SmallNetwork(), FeatureMatrix::Zero(2, 8)), std::invalid_argument);
  EXPECT_THROW(ScoresOf({}, FeatureMatrix::Zero(2, 0)), std::invalid_argument);
}

TEST(FeatureNetwork, ValidateRejectsPartsThatDoNotFit) {
  EXPECT_NO_THROW(FeatureNetwork{}.Validate());
  const auto rejects = [](auto&& change) {
    FeatureNetwork network = SmallNetwork();
    change(network);
    EXPECT_THROW(network.Validate(), std::invalid_argument);
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  rejects([](auto& n) { n.mean.resize(0), n.scale.resize(0); });
  rejects([](auto& n) { n.mean.conservativeResize(8); });
  rejects([](auto& n) { n.scale.conservativeResize(8); });
  rejects([](auto& n) { n.mean[3] = kNan; });
  rejects([](auto& n) { n.scale[3] = kNan; });
  rejects([](auto& n) { n.layers[1].weights(2, 2) = kNan; });
  rejects([](auto& n) { n.layers[1].bias[2] = kNan; });
  rejects([](auto& n) { n.layers[1].weights.conservativeResize(6, 5); });
  rejects([](auto& n) { n.layers[1].bias.conservativeResize(4); });
  rejects([](auto& n) { n.layers[1].weights.resize(7, 0), n.layers[1].bias.resize(0); });
  rejects([](auto& n) { n.layers[0].weights(0, 0) = 1e38F; });
  rejects([](auto& n) { n.layers.pop_back(); });
}

}  // namespace
}  // namespace fallen
