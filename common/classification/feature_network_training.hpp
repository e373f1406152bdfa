// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "fallen/classification/feature_network.hpp"

namespace fallen {

/// How a FeatureNetwork of two hidden layers is trained.
struct NetworkTrainingConfig {
  int epochs = 12;  ///< passes over the samples; 0: there is no network
  int first_units = 128;
  int second_units = 64;
  int batch_size = 256;          ///< samples a step
  double learning_rate = 0.002;  ///< of the first step; falls to 0 as half a cosine
  double dropout = 0.4;          ///< share of the hidden units left out in a step, [0, 1)
  double weight_decay = 1e-5;    ///< pull of each weight towards zero, >= 0
  std::int64_t seed = 1;

  /// @throws std::invalid_argument for the first setting that is out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("epochs", epochs);
    visit("first_units", first_units);
    visit("second_units", second_units);
    visit("batch_size", batch_size);
    visit("learning_rate", learning_rate);
    visit("dropout", dropout);
    visit("weight_decay", weight_decay);
    visit("seed", seed);
  }
};

/// Told after every step.
struct NetworkTrainingProgress {
  double done = 0;  ///< share of the steps
  double loss = 0;  ///< mean of log(1 + exp(-y F(x))) in the last batch, by the given weights
};

/// Trains on `features` (samples x features) with `labels` +1 or -1 and positive `weights` (empty:
/// all equal): the weighted log-loss, by [Kingma15] with [Srivastava14], from weights as [He15].
///
/// [He15]         He, Zhang, Ren, Sun: Delving deep into rectifiers. ICCV 2015.
/// [Kingma15]     Kingma, Ba: Adam: a method for stochastic optimization. ICLR 2015.
/// [Srivastava14] Srivastava et al.: Dropout: a simple way to prevent neural networks from
///                overfitting. JMLR 15, 2014.
/// @throws std::invalid_argument if sizes disagree, a value is not finite, or one class is missing.
/// Deterministic. O(epochs * samples * weights).
FeatureNetwork TrainFeatureNetwork(
    const Eigen::Ref<const FeatureMatrix>& features, std::span<const std::int8_t> labels,
    std::span<const float> weights, const NetworkTrainingConfig& config,
    const std::function<void(const NetworkTrainingProgress&)>& progress = {});

}  // namespace fallen
