// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "fallen/iron/iron_descriptor.hpp"

/// Codebook of reference descriptors (the paper, Sec. III-E).
///
/// [Fritzke95] Fritzke: A growing neural gas network learns topologies. NIPS 7, 1995.
namespace fallen {

struct GrowingNeuralGasConfig {
  int max_units = 128;          ///< size of the codebook, [2, 4096]
  std::int64_t steps = 400000;  ///< samples shown, drawn with replacement, >= 1
  /// lambda, samples between two insertions, >= 1; raised to steps / (2 max_units) where that is
  /// more, so that growth takes half of a long training and not its first moments.
  int insert_interval = 100;
  double winner_rate = 0.2;         ///< epsilon_b, (0, 1); this and all below: [Fritzke95] Sec. 3
  double neighbor_rate = 0.006;     ///< epsilon_n, (0, 1)
  double insert_error_decay = 0.5;  ///< alpha, (0, 1)
  double error_decay = 0.995;       ///< d, per step, (0, 1)
  int max_edge_age = 50;            ///< a_max, steps of the winner, >= 1
  std::int64_t seed = 1;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("max_units", max_units);
    visit("steps", steps);
    visit("insert_interval", insert_interval);
    visit("winner_rate", winner_rate);
    visit("neighbor_rate", neighbor_rate);
    visit("insert_error_decay", insert_error_decay);
    visit("error_decay", error_decay);
    visit("max_edge_age", max_edge_age);
    visit("seed", seed);
  }
};

/// Rows are unit vectors: the reference descriptors d_k.
using Codebook = IronDescriptors::Matrix;

/// Learns a codebook of `samples` (one descriptor a row) by a growing neural gas on the unit
/// sphere: the distance is 1 - cosine, and a unit is normalised again after each move.
/// @return At most `max_units` rows: fewer where `steps` end before the network has grown so far,
/// or
///         where units were removed at the very end.
/// @throws std::invalid_argument for fewer than two samples of distinct direction, zero samples not
///         counted, for samples that are not finite, and for `config` out of range.
/// Deterministic by seed. `progress` is told the share done, about 100 times. O(steps * max_units).
Codebook TrainGrowingNeuralGas(const Eigen::Ref<const IronDescriptors::Matrix>& samples,
                               const GrowingNeuralGasConfig& config,
                               const std::function<void(double)>& progress = {});

}  // namespace fallen
