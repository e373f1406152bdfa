// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fallen/segmentation/boosted_trees.hpp"

namespace fallen {

/// A feed-forward network that tells classes of feature vectors apart, flattened for use.
///
/// The input is (feature - mean) * scale, cut off kMaxDeviations from zero. Each layer gives
/// x * weights + bias; all but the last, of one output, cut off what is below zero [Glorot11]. The
/// output is the log-odds of the first class.
/// [Glorot11] Glorot, Bordes, Bengio: Deep sparse rectifier neural networks. AISTATS 2011.
struct FeatureNetwork {
  /// One standardized value further from the mean says nothing more.
  static constexpr float kMaxDeviations = 5;

  struct Layer {
    FeatureMatrix weights;  ///< inputs x outputs
    Eigen::RowVectorXf bias;
    bool operator==(const Layer& other) const;
  };
  Eigen::RowVectorXf mean;
  Eigen::RowVectorXf scale;   ///< one over the deviation
  std::vector<Layer> layers;  ///< none: there is no network

  bool empty() const { return layers.empty(); }
  /// What the first layer takes for a sample of `features`.
  template <class Row>
  auto Standardize(const Row& features) const {
    return ((features - mean).array() * scale.array())
        .cwiseMax(-kMaxDeviations)
        .cwiseMin(kMaxDeviations)
        .matrix();
  }
  Eigen::Index feature_count() const { return mean.size(); }
  /// @throws std::invalid_argument if there are layers and one does not fit to what is before it,
  /// the last has not one output, a value is not finite, or weights are so large that a score could
  /// become so.
  void Validate() const;
  bool operator==(const FeatureNetwork& other) const;
};

/// Scores samples, batch after batch in the same memory.
class NetworkScorer {
 public:
  /// Scores are nearly linear in the log-odds up to this, and still tell apart what lies beyond.
  static constexpr float kScoreScale = 16;

  /// @param network  Valid: see FeatureNetwork::Validate.
  explicit NetworkScorer(FeatureNetwork network);

  /// tanh(log-odds / kScoreScale), in [-1, 1]: one score a row of `features`, of as many columns as
  /// the network has features.
  /// @throws std::invalid_argument for other columns, or from no network.
  /// Deterministic: a row's score does not depend on the other rows. No allocation once `scores` is
  /// large enough.
  void Score(const Eigen::Ref<const FeatureMatrix>& features, std::vector<float>& scores);

 private:
  FeatureNetwork network_;
  Eigen::RowVectorXf input_, output_;  // of the layer at hand
};

}  // namespace fallen
