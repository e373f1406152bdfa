// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "random_cells.hpp"

#include <Eigen/Geometry>
#include <random>

namespace fallen {

NdtCell MakeCell(const Eigen::Vector3f& mean, const Eigen::Matrix3f& covariance) {
  return {mean,
          {covariance(0, 0), covariance(0, 1), covariance(0, 2), covariance(1, 1), covariance(1, 2),
           covariance(2, 2)},
          10,
          1.0f};
}

std::vector<NdtCell> RandomCells(int count, float size_m, const Eigen::Vector3f& center, int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-0.5f, 0.5f);
  std::vector<NdtCell> cells;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f mean =
        center +
        size_m * Eigen::Vector3f(uniform(generator), uniform(generator), uniform(generator));
    const Eigen::Quaternionf turn = Eigen::Quaternionf(uniform(generator), uniform(generator),
                                                       uniform(generator), uniform(generator))
                                        .normalized();
    Eigen::Vector3f eigenvalues(1e-6f, 1e-4f, 2e-4f);
    if (i % 10 == 8) eigenvalues = {1e-4f, 1.05e-4f, 2e-4f};
    if (i % 10 == 9) eigenvalues = {1e-6f, 1e-6f, 2e-4f};
    const Eigen::Matrix3f rotation = turn.toRotationMatrix();
    cells.push_back(MakeCell(mean, rotation * eigenvalues.asDiagonal() * rotation.transpose()));
  }
  return cells;
}

}  // namespace fallen
