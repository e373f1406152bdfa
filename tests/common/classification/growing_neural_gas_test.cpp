// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/growing_neural_gas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

// Tight clusters of non-negative vectors of any length around `centers`.
Codebook Around(const Codebook& centers, int each, float spread, std::mt19937& random) {
  std::normal_distribution<float> normal(0, spread);
  std::uniform_real_distribution<float> length(0.1F, 10);
  Codebook samples(centers.rows() * each, centers.cols());
  for (Eigen::Index i = 0; i < samples.rows(); ++i) {
    for (Eigen::Index k = 0; k < samples.cols(); ++k)
      samples(i, k) = std::max(0.0F, centers(i % centers.rows(), k) + normal(random));
    samples.row(i) *= length(random);
  }
  return samples;
}

Codebook Centers(int count, int dimension, std::mt19937& random) {
  Codebook centers = Codebook::Zero(count, dimension);
  for (Eigen::Index i = 0; i < centers.size(); ++i)
    if (random() % 4 == 0) centers.data()[i] = 1;
  centers.col(0).setConstant(0.1F);
  centers.rowwise().normalize();
  return centers;
}

double QuantizationError(const Codebook& samples, const Codebook& codebook) {
  double sum = 0;
  for (Eigen::Index i = 0; i < samples.rows(); ++i)
    sum += 1 - (codebook * samples.row(i).normalized().transpose()).maxCoeff();
  return sum / static_cast<double>(samples.rows());
}

GrowingNeuralGasConfig Small() {
  GrowingNeuralGasConfig config;
  config.max_units = 32;
  config.steps = 20000;
  return config;
}

TEST(GrowingNeuralGas, GivesUnitVectorsAsManyAsAskedFor) {
  std::mt19937 random(1);
  const Codebook samples = Around(Centers(20, 12, random), 100, 0.1F, random);
  const Codebook codebook = TrainGrowingNeuralGas(samples, Small());
  EXPECT_EQ(codebook.rows(), 32);
  EXPECT_EQ(codebook.cols(), 12);
  for (Eigen::Index i = 0; i < codebook.rows(); ++i) EXPECT_NEAR(codebook.row(i).norm(), 1, 1e-6);
}

TEST(GrowingNeuralGas, PutsAUnitIntoEveryClusterWhateverItsLength) {
  std::mt19937 random(2);
  const Codebook centers = Centers(16, 48, random);
  const Codebook samples = Around(centers, 100, 0.01F, random);
  const Codebook codebook = TrainGrowingNeuralGas(samples, Small());
  for (Eigen::Index c = 0; c < centers.rows(); ++c)
    EXPECT_GT((codebook * centers.row(c).transpose()).maxCoeff(), 0.99F) << "cluster " << c;
}

TEST(GrowingNeuralGas, QuantizesBetterThanRandomSamplesAsCodebook) {
  std::mt19937 random(3);
  const Codebook samples = Around(Centers(40, 24, random), 100, 0.15F, random);
  const double trained = QuantizationError(samples, TrainGrowingNeuralGas(samples, Small()));
  for (int trial = 0; trial < 5; ++trial) {
    Codebook drawn(32, 24);
    for (Eigen::Index i = 0; i < drawn.rows(); ++i)
      drawn.row(i) = samples.row(random() % samples.rows()).normalized();
    EXPECT_LT(trained, 0.8 * QuantizationError(samples, drawn));
  }
}

TEST(GrowingNeuralGas, IsDeterminedByItsSeed) {
  std::mt19937 random(4);
  const Codebook samples = Around(Centers(8, 10, random), 50, 0.1F, random);
  GrowingNeuralGasConfig config = Small();
  config.steps = 3000;
  const Codebook once = TrainGrowingNeuralGas(samples, config);
  EXPECT_EQ(TrainGrowingNeuralGas(samples, config), once);
  config.seed = 2;
  const Codebook other = TrainGrowingNeuralGas(samples, config);
  EXPECT_TRUE(other.rows() != once.rows() || other != once);
}

TEST(GrowingNeuralGas, ReportsProgressUpToOne) {
  std::mt19937 random(5);
  const Codebook samples = Around(Centers(4, 6, random), 20, 0.1F, random);
  std::vector<double> shares;
  TrainGrowingNeuralGas(samples, Small(), [&](double share) { shares.push_back(share); });
  EXPECT_EQ(shares.size(), 100U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(GrowingNeuralGas, PassesOverZeroSamples) {
  Codebook samples = Codebook::Zero(50, 3);
  samples.row(20) << 1, 0, 0;
  samples.row(30) << 0, 5, 0;
  GrowingNeuralGasConfig config = Small();
  config.max_units = 2;
  config.steps = 500;
  const Codebook codebook = TrainGrowingNeuralGas(samples, config);
  ASSERT_EQ(codebook.rows(), 2);
  EXPECT_TRUE(codebook.allFinite());
}

TEST(GrowingNeuralGas, RejectsBrokenSamplesAndSettings) {
  const auto rejects = [](const Codebook& samples, const GrowingNeuralGasConfig& config = {}) {
    EXPECT_THROW(TrainGrowingNeuralGas(samples, config), std::invalid_argument);
  };
  rejects(Codebook(0, 4));
  rejects(Codebook::Zero(10, 4));
  rejects(Codebook::Ones(1, 4));
  Codebook same_direction = Codebook::Ones(3, 4);
  same_direction.row(1) *= 2;
  rejects(same_direction);
  Codebook broken = Codebook::Identity(4, 4);
  broken(1, 2) = std::nanf("");
  rejects(broken);
  const Codebook good = Codebook::Identity(4, 4);
  const auto with = [](auto&& change) {
    GrowingNeuralGasConfig config;
    change(config);
    return config;
  };
  rejects(good, with([](auto& c) { c.max_units = 1; }));
  rejects(good, with([](auto& c) { c.steps = 0; }));
  rejects(good, with([](auto& c) { c.insert_interval = 0; }));
  rejects(good, with([](auto& c) { c.winner_rate = 1; }));
  rejects(good, with([](auto& c) { c.neighbor_rate = std::nan(""); }));
  rejects(good, with([](auto& c) { c.insert_error_decay = -0.5; }));
  rejects(good, with([](auto& c) { c.error_decay = 0; }));
  rejects(good, with([](auto& c) { c.max_edge_age = 0; }));
}

}  // namespace
}  // namespace fallen
