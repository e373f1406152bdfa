// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>

#include "fallen/iron/iron_descriptor.hpp"

/// Codebook of reference descriptors (the paper, Sec. III-E).
///
/// [Fritzke95] Fritzke: A growing neural gas network learns topologies. NIPS 7, 1995.
namespace fallen {

struct GrowingNeuralGasConfig {
  int max_units = 128;              ///< size of the codebook
  std::int64_t steps = 400000;      ///< samples shown, drawn with replacement
  int insert_interval = 100;        ///< lambda [Fritzke95]; raised if steps / max_units asks for it
  double winner_rate = 0.2;         ///< epsilon_b
  double neighbor_rate = 0.006;     ///< epsilon_n
  double insert_error_decay = 0.5;  ///< alpha
  double error_decay = 0.995;       ///< d, per step
  int max_edge_age = 50;            ///< a_max
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

/// Learns a codebook of `samples` (one descriptor a row) by a growing neural gas on the unit sphere:
/// the distance is 1 - cosine, and a unit is normalised again after each move.
/// @throws std::invalid_argument for fewer than two distinct non-zero samples.
/// Deterministic by seed. `progress` is told the share done, about 100 times.
Codebook TrainGrowingNeuralGas(const Eigen::Ref<const IronDescriptors::Matrix>& samples,
                               const GrowingNeuralGasConfig& config,
                               const std::function<void(double)>& progress = {});

}  // namespace fallen
