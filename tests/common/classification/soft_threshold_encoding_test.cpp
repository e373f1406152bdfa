// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/soft_threshold_encoding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

Codebook RandomUnits(int rows, int columns, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  Codebook units = Codebook::NullaryExpr(rows, columns, [&] { return uniform(random); });
  units.rowwise().normalize();
  return units;
}

TEST(EncodeCluster, IsTheFormulaInDouble) {
  std::mt19937 random(1);
  const Codebook codebook = RandomUnits(40, 48, random);
  Codebook descriptors = RandomUnits(25, 48, random) * 0.3F;
  descriptors.row(7).setZero();
  for (const double alpha : {-1.0, 0.0, 0.7, 0.8}) {
    const Eigen::VectorXd code = EncodeCluster(descriptors, codebook, alpha);
    ASSERT_EQ(code.size(), 40);
    for (int k = 0; k < 40; ++k) {
      double sum = 0;
      for (int i = 0; i < 25; ++i) {
        double dot = 0, sq_norm = 0;
        for (int j = 0; j < 48; ++j) {
          dot += static_cast<double>(codebook(k, j)) * descriptors(i, j);
          sq_norm += static_cast<double>(descriptors(i, j)) * descriptors(i, j);
        }
        if (sq_norm > 0) sum += std::max(0.0, dot / std::sqrt(sq_norm) - alpha);
      }
      // Cosines are computed in float.
      EXPECT_NEAR(code[k], sum / 25, 1e-6);
    }
  }
}

TEST(EncodeCluster, DoesNotDependOnTheNumberOfCellsOrTheirLength) {
  std::mt19937 random(2);
  const Codebook codebook = RandomUnits(10, 8, random);
  const Codebook once = RandomUnits(5, 8, random);
  Codebook thrice(15, 8);
  thrice << once, 2 * once, 0.5F * once;
  EXPECT_LT((EncodeCluster(once, codebook, 0.5) - EncodeCluster(thrice, codebook, 0.5)).norm(),
            1e-6);
}

TEST(EncodeCluster, GivesAZeroCodeForZeroDescriptorsAndHighThresholds) {
  std::mt19937 random(3);
  const Codebook codebook = RandomUnits(10, 8, random);
  EXPECT_EQ(EncodeCluster(Codebook::Zero(4, 8), codebook, 0.1), Eigen::VectorXd::Zero(10));
  EXPECT_EQ(EncodeCluster(RandomUnits(4, 8, random), codebook, 1.001), Eigen::VectorXd::Zero(10));
}

TEST(EncodeCluster, RejectsNoRowsAndOtherDimensions) {
  const Codebook codebook = Codebook::Identity(3, 3);
  EXPECT_THROW(EncodeCluster(Codebook(0, 3), codebook, 0.5), std::invalid_argument);
  EXPECT_THROW(EncodeCluster(Codebook::Ones(2, 4), codebook, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
