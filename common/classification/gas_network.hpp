// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/classification/growing_neural_gas.hpp"

namespace fallen {

/// The network that TrainGrowingNeuralGas adapts: units on the unit sphere, and edges that age.
///
/// Invariants: every unit is a unit vector; edges join two different units and are symmetric; no
/// edge is older than `max_edge_age`; every unit has an edge; errors are >= 0.
class GasNetwork {
 public:
  using Unit = Eigen::VectorXf;

  /// Two joined units.
  /// @param config  Its `max_units` bounds the network.
  GasNetwork(const Unit& first, const Unit& second, const GrowingNeuralGasConfig& config);

  /// Shows one sample, a unit vector: steps 3 to 7 and 9 of [Fritzke95] Sec. 2.
  void Adapt(const Eigen::Ref<const Unit>& sample);

  /// Puts a unit between the unit of the largest error and its neighbour of the largest error:
  /// step 8 of [Fritzke95]. Does nothing once there are `max_units`.
  void Insert();

  int unit_count() const { return unit_count_; }
  auto units() const { return units_.topRows(unit_count_); }
  auto errors() const { return errors_.head(unit_count_); }
  /// Age of the edge between two units, or -1 where there is none.
  int edge_age(int a, int b) const { return ages_[static_cast<std::size_t>(a * max_units_ + b)]; }

 private:
  static constexpr int kNoEdge = -1;

  int& Age(int a, int b) { return ages_[static_cast<std::size_t>(a * max_units_ + b)]; }
  void SetEdge(int a, int b, int age);
  void MoveTowards(int unit, const Eigen::Ref<const Unit>& sample, double rate);
  bool IsIsolated(int unit) const;
  void Remove(int unit);
  int NeighborOfLargestError(int unit) const;

  GrowingNeuralGasConfig config_;
  int max_units_;
  int unit_count_ = 2;
  Codebook units_;          // max_units x dimension, the first unit_count_ rows are in use
  Eigen::VectorXd errors_;  // sums of 1 - cosine, decayed
  std::vector<int> ages_;   // max_units x max_units
  Eigen::VectorXf cosines_;
};

}  // namespace fallen
