// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/feature_binning.hpp"

namespace fallen {

/// What a split is chosen by. Both are summed over the children and made as small as possible.
enum class SplitCriterion {
  kGini,             ///< 2 w+ w- / (w+ + w-): also the squared error of the mean label
  kExponentialLoss,  ///< 2 sqrt(w+ w-), [Schapire99] Eq. 9
};

struct TreeGrowingConfig {
  int max_depth = 4;
  double min_leaf_weight = 1e-4;  ///< share of the total weight
  SplitCriterion criterion = SplitCriterion::kGini;
};

/// A tree whose leaves do not vote yet, and what lies in them.
struct GrownTree {
  struct LeafWeights {
    double positive = 0;
    double negative = 0;
  };
  std::vector<BoostedTrees::Node> nodes;   ///< the root first
  std::vector<LeafWeights> weights;        ///< of the samples in each node
  std::vector<std::int32_t> leaf_indices;  ///< per sample: the node it ends in
};

/// Grows one tree, level by level.
///
/// @param is_positive  One flag a sample.
/// @param weights      One a sample, >= 0, with a positive sum.
/// Ties go to the smaller feature, then to the smaller cut. The result does not depend on
/// `threads`: every histogram is summed by one thread in the samples' order.
GrownTree GrowTree(const BinnedFeatures& features, std::span<const std::uint8_t> is_positive,
                   std::span<const double> weights, const TreeGrowingConfig& config, int threads);

}  // namespace fallen
