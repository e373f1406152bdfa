// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_gate.hpp"

#include <stdexcept>
#include <string>

namespace fallen {
namespace {

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("cell_gate: " + what);
}

}  // namespace

void CellGate::Validate() const {
  if (!(min_score >= -1 && min_score <= 1))
    Fail("min_score is " + std::to_string(min_score) + ", must be in [-1, 1]");
  if (!(turned_away_score >= -1 && turned_away_score <= 1))
    Fail("turned_away_score is " + std::to_string(turned_away_score) + ", must be in [-1, 1]");
  if (is_open()) return;
  trees.Validate();
  if (trees.feature_count != kShapeFeatureCount)
    Fail("the trees take " + std::to_string(trees.feature_count) + " features, must take " +
         std::to_string(kShapeFeatureCount));
}

std::span<const float> GateKeeper::Score(const NdtMap& map,
                                         const Eigen::Ref<const FeatureMatrix>& shapes) {
  if (gate_.is_open() || !map.ground.ok()) return {};
  scorer_.Score(shapes, scores_);
  return scores_;
}

}  // namespace fallen
