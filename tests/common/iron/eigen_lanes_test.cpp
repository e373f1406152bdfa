// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/eigen_lanes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

Eigen::Matrix3f MatrixOf(const MatrixBatch& batch, std::size_t lane) {
  const auto& m = batch.coefficients;
  Eigen::Matrix3f matrix;
  matrix << m[0][lane], m[1][lane], m[2][lane],  //
      m[1][lane], m[3][lane], m[4][lane],        //
      m[2][lane], m[4][lane], m[5][lane];
  return matrix;
}

void ExpectLikeEigen(const MatrixBatch& batch) {
  test::AtEverySimdLevel([&](SimdLevel level) {
    EigenBatch result;
    DecomposeLikeEigen(batch, result);
    for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
      const Eigen::Matrix3f matrix = MatrixOf(batch, lane);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(matrix);
      ASSERT_EQ(result.converged[lane] != 0, solver.info() == Eigen::Success) << matrix;
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(result.values[k][lane], solver.eigenvalues()[k])
            << "level " << static_cast<int>(level) << "\n"
            << matrix;
        ASSERT_EQ(result.smallest[k][lane], solver.eigenvectors()(k, 0))
            << "level " << static_cast<int>(level) << "\n"
            << matrix;
      }
    }
  });
}

void Put(const Eigen::Matrix3f& m, std::size_t lane, MatrixBatch& batch) {
  const float values[6] = {m(0, 0), m(1, 0), m(2, 0), m(1, 1), m(2, 1), m(2, 2)};
  for (int k = 0; k < 6; ++k) batch.coefficients[k][lane] = values[k];
}

TEST(DecomposeLikeEigen, GivesEigensBitsForCovariances) {
  std::mt19937 random(3);
  std::normal_distribution<float> gaussian;
  for (int trial = 0; trial < 500; ++trial) {
    MatrixBatch batch;
    for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
      const Eigen::Matrix3f axes =
          Eigen::Quaternionf(gaussian(random), gaussian(random), gaussian(random), gaussian(random))
              .normalized()
              .toRotationMatrix();
      const Eigen::Vector3f values(1e-6f, 1e-5f * std::abs(gaussian(random)), 2e-4f);
      Put(axes * values.asDiagonal() * axes.transpose(), lane, batch);
    }
    ExpectLikeEigen(batch);
  }
}

TEST(DecomposeLikeEigen, GivesEigensBitsForWhatIsSpecial) {
  MatrixBatch batch = {};  // lane 0: zero
  Put(Eigen::Matrix3f::Identity(), 1, batch);
  Put(Eigen::Vector3f(3, 1, 2).asDiagonal(), 2, batch);
  Put(Eigen::Matrix3f::Ones(), 3, batch);
  Put(-Eigen::Matrix3f::Ones(), 4, batch);
  Eigen::Matrix3f m;
  m << 0, 1, 0, 1, 0, 0, 0, 0, 5;
  Put(m, 5, batch);
  m << 5, 0, 0, 0, 0, 1, 0, 1, 0;
  Put(m, 6, batch);
  m << 0, 0, 1, 0, 5, 0, 1, 0, 0;
  Put(m, 7, batch);
  m << 1, 1e-20f, 1e-25f, 1e-20f, 1, 1e-18f, 1e-25f, 1e-18f, 1;
  Put(m, 8, batch);
  m << 1, 1e-3f, 0, 1e-3f, 1, 1e-7f, 0, 1e-7f, 1;
  Put(m, 9, batch);
  Put(1e-30f * Eigen::Matrix3f::Ones(), 10, batch);
  Put(1e30f * Eigen::Matrix3f::Ones(), 11, batch);
  m << 2, 0, 1e-30f, 0, 1, 0, 1e-30f, 0, 1;
  Put(m, 12, batch);
  m << 0, 0.5f, 0, 0.5f, 0, 0.5f, 0, 0.5f, 0;
  Put(m, 13, batch);
  ExpectLikeEigen(batch);
}

}  // namespace
}  // namespace fallen
