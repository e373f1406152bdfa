// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "fallen/ndt/ndt_map.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/shape_features.hpp"
#include "fallen/segmentation/tree_scorer.hpp"

namespace fallen {

/// A first look at cells, before they have a descriptor: the first stage of a cascade [Viola01].
///
/// Most of a room is walls, table tops and shelves, whose shape and height give them away. Cells
/// that the gate turns away get no descriptor, which is what costs most, and are never a person's.
///
/// [Viola01] Viola, Jones: Rapid object detection using a boosted cascade of simple features. CVPR
///           2001.
struct CellGate {
  BoostedTrees trees;     ///< over ComputeShapeFeatures; none: all cells pass, as in the paper
  double min_score = -1;  ///< cells with a lower score are turned away, [-1, 1]
  /// What the cell classifier says of such cells on average: their score from then on, [-1, 1].
  double turned_away_score = -1;

  bool is_open() const { return trees.roots.empty(); }
  bool Passes(float score) const { return static_cast<double>(score) >= min_score; }

  /// @throws std::invalid_argument for values out of range, or trees of another number of features.
  void Validate() const;
};

/// A gate prepared to judge frame after frame. Not thread-safe.
class GateKeeper {
 public:
  /// @param gate  Valid: see CellGate::Validate.
  explicit GateKeeper(const CellGate& gate) : gate_(gate), scorer_(gate.trees) {}

  /// One score a row of `shapes`, columns of ComputeShapeFeatures; holds until the next call. None
  /// if all cells pass unseen: where the gate is open, and where no floor is known that heights
  /// could be measured from.
  std::span<const float> Score(const NdtMap& map, const Eigen::Ref<const FeatureMatrix>& shapes);

  const CellGate& gate() const { return gate_; }

 private:
  CellGate gate_;
  TreeScorer scorer_;
  std::vector<float> scores_;
};

}  // namespace fallen
