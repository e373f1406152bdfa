// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/detection/model.hpp"

namespace fallen {

/// A model that takes every cell for a person's and every cluster for a person: for tests of what
/// lies around the method. Its probabilities fall with the distance as any model's do.
inline Model PlainModel() {
  Model model;
  model.description = "every cluster is a person";
  model.cells.trees.feature_count = CellFeatureCount(model.cells.iron, model.cells.features);
  model.cells.trees.roots = {0};
  model.cells.trees.nodes = {{-1, 0, 0, 1}};

  constexpr Eigen::Index kUnits = 4;
  const Eigen::Index dimension = model.clusters.iron.dimension();
  model.clusters.codebook.setZero(kUnits, dimension);
  for (Eigen::Index k = 0; k < kUnits; ++k) model.clusters.codebook(k, k * 5) = 1;
  model.clusters.alpha = 0;
  model.clusters.gaussian = MahalanobisModel(Eigen::VectorXd::Constant(kUnits, 0.2),
                                             Eigen::MatrixXd::Identity(kUnits, kUnits) * 0.04);
  model.clusters.calibration.operating_points = {{0, 0.01, 0}};
  return model;
}

}  // namespace fallen
