// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/synthetic_model.hpp"

#include <random>

namespace fallen::testing_support {
namespace {

constexpr int kCodeWords = 16;
constexpr std::uint32_t kSeed = 7;

/// Two stumps on the first values of the descriptor: scores vary from cell to cell.
BoostedTrees SyntheticTrees(int feature_count) {
  BoostedTrees trees;
  trees.feature_count = feature_count;
  for (int stump = 0; stump < 2; ++stump) {
    const auto root = static_cast<std::int32_t>(trees.nodes.size());
    trees.roots.push_back(root);
    trees.nodes.push_back({stump, 0.1F, root + 1, 0});
    trees.nodes.push_back({-1, 0, 0, 1.0F});
    trees.nodes.push_back({-1, 0, 0, 0.25F - 0.1F * static_cast<float>(stump)});
  }
  return trees;
}

/// Turns away what is higher than a fallen person.
CellGate SyntheticGate() {
  CellGate gate;
  gate.trees.feature_count = kShapeFeatureCount;
  gate.trees.roots = {0};
  constexpr int kHeight = 3;
  gate.trees.nodes = {{kHeight, 0.7F, 1, 0}, {-1, 0, 0, 1}, {-1, 0, 0, -1}};
  gate.min_score = 0;
  gate.turned_away_score = -0.1;
  return gate;
}

}  // namespace

Model SyntheticModel(double cell_size_m) {
  Model model;
  model.description = "synthetic, for tests";
  model.cells.cell_size_m = cell_size_m;
  model.cells.trees = SyntheticTrees(CellFeatureCount(model.cells.iron, model.cells.features));
  model.cells.gate = SyntheticGate();
  model.clusters.iron = model.cells.iron;

  std::mt19937 generator(kSeed);
  const int dimension = model.cells.iron.dimension();
  model.clusters.codebook.resize(kCodeWords, dimension);
  for (int k = 0; k < kCodeWords; ++k) {
    for (int i = 0; i < dimension; ++i)  // of the raw generator: distributions differ by library
      model.clusters.codebook(k, i) = static_cast<float>(generator() % 1000 + 1);
    model.clusters.codebook.row(k).normalize();
  }
  model.clusters.alpha = 0.3;
  model.clusters.gaussian =
      MahalanobisModel(Eigen::VectorXd::Constant(kCodeWords, 0.2),
                       0.01 * Eigen::MatrixXd::Identity(kCodeWords, kCodeWords));
  model.clusters.calibration.slope = 2;
  model.clusters.calibration.intercept = 4;
  model.clusters.calibration.operating_points = {{0.1, 0.5, 0.0}, {0.5, 0.01, 0.1}};
  model.Validate();
  return model;
}

}  // namespace fallen::testing_support
