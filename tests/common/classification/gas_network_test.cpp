// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/gas_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace fallen {
namespace {

using Unit = GasNetwork::Unit;

Unit At(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  Unit unit(2);
  unit << static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle));
  return unit;
}

// [Fritzke95] Sec. 2, as properties of every state.
void ExpectInvariants(const GasNetwork& network, const GrowingNeuralGasConfig& config) {
  ASSERT_GE(network.unit_count(), 2);
  ASSERT_LE(network.unit_count(), config.max_units);
  for (int a = 0; a < network.unit_count(); ++a) {
    EXPECT_NEAR(network.units().row(a).norm(), 1, 1e-6);
    EXPECT_GE(network.errors()[a], 0);
    EXPECT_EQ(network.edge_age(a, a), -1);
    int edges = 0;
    for (int b = 0; b < network.unit_count(); ++b) {
      EXPECT_EQ(network.edge_age(a, b), network.edge_age(b, a));
      EXPECT_LE(network.edge_age(a, b), config.max_edge_age);
      edges += network.edge_age(a, b) >= 0;
    }
    EXPECT_GT(edges, 0) << "unit " << a << " is isolated";
  }
}

TEST(GasNetwork, KeepsFritzkesInvariantsInEveryStep) {
  GrowingNeuralGasConfig config;
  config.max_units = 24;
  config.max_edge_age = 12;
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  const auto draw = [&](int step) {
    Unit sample(6);
    for (float& value : sample) value = normal(random);
    // The distribution jumps, so that units are left behind and removed.
    sample[(step / 500) % 6] += 6;
    return Unit(sample.normalized());
  };
  GasNetwork network(draw(0), draw(0), config);
  int removals = 0;
  for (int step = 1; step <= 4000; ++step) {
    const int before = network.unit_count();
    network.Adapt(draw(step));
    removals += before - network.unit_count();
    if (step % 20 == 0) network.Insert();
    ExpectInvariants(network, config);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(removals, 0);
  EXPECT_GT(network.unit_count(), 12);
}

TEST(GasNetwork, MovesTheWinnerAndItsNeighboursByTheirRates) {
  GrowingNeuralGasConfig config;
  config.winner_rate = 0.25;
  config.neighbor_rate = 0.125;
  config.error_decay = 0.5;
  GasNetwork network(At(0), At(90), config);
  network.Adapt(At(30));
  const Unit winner = (At(0) * 0.75F + At(30) * 0.25F).normalized();
  const Unit neighbor = (At(90) * 0.875F + At(30) * 0.125F).normalized();
  EXPECT_LT((network.units().row(0).transpose() - winner).norm(), 1e-6F);
  EXPECT_LT((network.units().row(1).transpose() - neighbor).norm(), 1e-6F);
  EXPECT_NEAR(network.errors()[0], 0.5 * (1 - std::cos(std::numbers::pi / 6)), 1e-6);
  EXPECT_EQ(network.errors()[1], 0);
  EXPECT_EQ(network.edge_age(0, 1), 0);
}

TEST(GasNetwork, InsertsBetweenTheWorstUnitAndItsWorstNeighbour) {
  GrowingNeuralGasConfig config;
  config.max_units = 3;
  config.winner_rate = 1e-6;  // units stay where they are
  config.neighbor_rate = 1e-6;
  config.error_decay = 1 - 1e-9;
  GasNetwork network(At(0), At(90), config);
  for (int i = 0; i < 4; ++i) network.Adapt(At(20));
  network.Adapt(At(80));
  const double first = network.errors()[0];
  const double second = network.errors()[1];
  network.Insert();
  ASSERT_EQ(network.unit_count(), 3);
  EXPECT_LT((network.units().row(2).transpose() - At(45)).norm(), 1e-4F);
  EXPECT_EQ(network.edge_age(0, 1), -1);
  EXPECT_EQ(network.edge_age(0, 2), 0);
  EXPECT_EQ(network.edge_age(1, 2), 0);
  EXPECT_DOUBLE_EQ(network.errors()[0], first / 2);
  EXPECT_DOUBLE_EQ(network.errors()[1], second / 2);
  EXPECT_DOUBLE_EQ(network.errors()[2], first / 2);
  network.Insert();  // full
  EXPECT_EQ(network.unit_count(), 3);
}

TEST(GasNetwork, RemovesAnEdgeThatIsTooOldAndTheUnitItLeavesAlone) {
  GrowingNeuralGasConfig config;
  config.max_edge_age = 5;
  config.winner_rate = 1e-6;
  config.neighbor_rate = 1e-6;
  GasNetwork network(At(0), At(90), config);
  network.Adapt(At(0));
  network.Insert();  // unit 2 at 45 degrees, joined with both
  for (int i = 1; i <= 5; ++i) {
    network.Adapt(At(35));  // unit 2 wins, unit 0 is second: the edge to unit 1 ages
    ASSERT_EQ(network.unit_count(), 3);
    EXPECT_EQ(network.edge_age(1, 2), i);
  }
  network.Adapt(At(35));
  ASSERT_EQ(network.unit_count(), 2);
  EXPECT_EQ(network.edge_age(0, 1), 0);
  EXPECT_LT((network.units().row(0).transpose() - At(0)).norm(), 1e-4F);
  EXPECT_LT((network.units().row(1).transpose() - At(45)).norm(), 1e-4F);
}

TEST(GasNetwork, SurvivesOppositeUnits) {
  GasNetwork network(At(0), -At(0), {});
  network.Insert();  // no middle on the circle: nothing is inserted
  EXPECT_EQ(network.unit_count(), 2);
  network.Adapt(At(90));
  EXPECT_TRUE(network.units().allFinite());
}

}  // namespace
}  // namespace fallen
