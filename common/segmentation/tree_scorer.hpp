// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/tree_walk.hpp"

namespace fallen {

/// A boosted ensemble prepared to score many rows: see PredictScores, which gives the same scores.
///
/// Votes are rounded to 2^-31 of the largest possible sum, so that they add up exactly in any
/// order; a score is off by at most trees / 2^32. Thread-safe after construction.
class TreeScorer {
 public:
  /// @param model  Valid: see BoostedTrees::Validate.
  explicit TreeScorer(const BoostedTrees& model);

  /// One score a row of `features`, into memory that is there.
  /// @throws std::invalid_argument if the column count differs from the model's or a feature is not
  /// finite.
  void Score(const Eigen::Ref<const FeatureMatrix>& features, std::vector<float>& scores) const;

 private:
  WalkTree WalkTreeOf(std::int32_t root) const;
  void FillUp(std::int32_t from, std::uint32_t at, WalkTree& tree) const;
  std::int32_t VoteOfDeep(std::int32_t root, const float* row) const;

  BoostedTrees model_;                // nodes of deep trees are walked as they are
  double unit_ = 0;                   // of the whole-number votes; 0: nobody votes
  std::vector<std::int32_t> votes_;   // by node of the model
  std::vector<WalkTree> walk_trees_;  // up to WalkTree::kDepth deep
  std::vector<WalkFork> walk_forks_;  // one deeper
  std::vector<std::int32_t> deep_roots_;
};

}  // namespace fallen
