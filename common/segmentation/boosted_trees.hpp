// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fallen/geometry/enum_names.hpp"

/// AdaBoost over decision trees (the paper, Sec. III-D.2).
///
/// [Freund95]   Freund, Schapire: A decision-theoretic generalization of on-line learning and an
///              application to boosting. EuroCOLT 1995.
/// [Friedman00] Friedman, Hastie, Tibshirani: Additive logistic regression. Annals of
/// Statistics 28. [Friedman01] Friedman: Greedy function approximation: a gradient boosting
/// machine. Annals of Statistics 29. [Schapire99] Schapire, Singer: Improved boosting algorithms
/// using confidence-rated predictions.
///              Machine Learning 37.
namespace fallen {

using FeatureMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A boosted ensemble of binary decision trees, flattened for use.
///
/// All nodes of all trees lie in one array. An inner node sends x to `left` if
/// x[feature] <= threshold, else to left + 1; a leaf has feature -1 and votes `value`.
/// Invariant (checked by Validate): children come after their parent, so evaluation ends.
struct BoostedTrees {
  struct Node {
    std::int32_t feature = -1;
    float threshold = 0;
    std::int32_t left = 0;
    float value = 0;
    bool operator==(const Node&) const = default;
  };
  std::int32_t feature_count = 0;
  std::vector<std::int32_t> roots;
  std::vector<Node> nodes;

  /// @throws std::invalid_argument for a structure that evaluation could not survive.
  void Validate() const;
  bool operator==(const BoostedTrees&) const = default;
};

/// Sum of the trees' votes divided by the sum of their largest absolute votes: in [-1, 1], positive
/// means person. One score a row of `features`; 0 from a model whose trees do not vote.
/// @param model  Valid: see BoostedTrees::Validate.
/// @throws std::invalid_argument if the column count differs from the model's or a feature is not
/// finite.
/// Deterministic: a row's score does not depend on the other rows. O(rows * trees * depth).
std::vector<float> PredictScores(const BoostedTrees& model,
                                 const Eigen::Ref<const FeatureMatrix>& features);

enum class BoostingVariant : std::int32_t {
  kDiscrete = 0,  ///< every tree votes with one weight [Freund95]
  kReal = 1,      ///< every leaf votes half its log-odds [Friedman00] Alg. 2, [Schapire99]
  kGentle = 2,    ///< every leaf votes its mean label [Friedman00] Alg. 4
};
constexpr auto EnumNames(BoostingVariant) {
  return EnumTable<BoostingVariant, 3>{{{BoostingVariant::kDiscrete, "discrete"},
                                        {BoostingVariant::kReal, "real"},
                                        {BoostingVariant::kGentle, "gentle"}}};
}

struct BoostingConfig {
  BoostingVariant variant = BoostingVariant::kGentle;
  int rounds = 150;               ///< trees at most, >= 1
  int max_depth = 4;              ///< decisions from root to leaf, [1, 10]
  double min_leaf_weight = 1e-4;  ///< share of the total weight that a leaf must hold, [0, 0.5)
  /// Share of its vote that a tree is given, (0, 1]: with small steps many trees learn more evenly
  /// than few [Friedman01].
  double learning_rate = 1;
  int threshold_bins = 256;  ///< bins a feature is cut into at its quantiles, [2, 256]

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("variant", variant);
    visit("rounds", rounds);
    visit("max_depth", max_depth);
    visit("min_leaf_weight", min_leaf_weight);
    visit("learning_rate", learning_rate);
    visit("threshold_bins", threshold_bins);
  }
};

/// Told after every round.
struct BoostingProgress {
  int round = 0;  ///< trees so far
  double training_error =
      0;  ///< share, by the given weights, of samples whose score has a wrong sign
  /// Mean of exp(-y F(x)) by the given weights: boosting's upper bound of the training error
  /// [Schapire99] Theorem 1, falls in every round.
  double exponential_loss = 0;
};

/// Trains on `features` (samples x features) with `labels` +1 (person) or -1 and positive `weights`
/// (empty: all equal).
///
/// Trees are grown greedily from histograms of the weights over at most 256 quantile bins a
/// feature; a split is chosen by the Gini impurity, for kReal by the exponential loss [Schapire99]
/// Eq. 9. Ends before `rounds` where no tree gains anything any more.
/// @param threads  Threads to use; 0: as many as the machine has. They change nothing but the time:
///                 the trees are bit-identical.
/// @throws std::invalid_argument if sizes disagree, a value is not finite, or one class is missing.
/// Deterministic.
BoostedTrees TrainBoostedTrees(const Eigen::Ref<const FeatureMatrix>& features,
                               std::span<const std::int8_t> labels, std::span<const float> weights,
                               const BoostingConfig& config,
                               const std::function<void(const BoostingProgress&)>& progress = {},
                               int threads = 0);

}  // namespace fallen
