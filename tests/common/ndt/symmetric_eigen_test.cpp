// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/symmetric_eigen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace fallen {
namespace {

SymmetricMatrix3 Triangle(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

Eigen::Matrix3d RandomRotation(std::mt19937& generator) {
  std::normal_distribution<double> gaussian;
  return Eigen::Quaterniond(gaussian(generator), gaussian(generator), gaussian(generator),
                            gaussian(generator))
      .normalized()
      .toRotationMatrix();
}

// The definition: A v = lambda v, orthonormal vectors, values ascending and those of Eigen's
// iterative solver.
void ExpectDecomposes(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d symmetric = (matrix + matrix.transpose()) / 2;
  const SymmetricEigen3 eigen = DecomposeSymmetric(Triangle(symmetric));
  const double scale = symmetric.cwiseAbs().maxCoeff();
  Eigen::Matrix3d vectors;
  for (int i = 0; i < 3; ++i)
    vectors.col(i) << eigen.vectors[i][0], eigen.vectors[i][1], eigen.vectors[i][2];
  EXPECT_TRUE((vectors.transpose() * vectors).isIdentity(1e-12)) << symmetric;
  const Eigen::Vector3d values(eigen.values[0], eigen.values[1], eigen.values[2]);
  EXPECT_LE(values[0], values[1]);
  EXPECT_LE(values[1], values[2]);
  const Eigen::Matrix3d residual = symmetric * vectors - vectors * values.asDiagonal();
  EXPECT_LE(residual.cwiseAbs().maxCoeff(), 1e-13 * scale) << symmetric;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  EXPECT_LE((solver.eigenvalues() - values).cwiseAbs().maxCoeff(), 1e-14 * scale) << symmetric;
}

TEST(DecomposeSymmetric, AgreesWithIterativeSolverOnRandomMatrices) {
  std::mt19937 generator(1);
  std::normal_distribution<double> gaussian;
  for (int trial = 0; trial < 2000; ++trial) {
    Eigen::Matrix3d matrix;
    for (int k = 0; k < 9; ++k) matrix(k) = gaussian(generator);
    ExpectDecomposes(matrix);
  }
}

TEST(DecomposeSymmetric, SurvivesEqualAndNearlyEqualEigenvalues) {
  std::mt19937 generator(2);
  for (const Eigen::Vector3d& values :
       {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(0, 0, 1),
        Eigen::Vector3d(1, 1, 2), Eigen::Vector3d(-1, 0, 1), Eigen::Vector3d(1, 1 + 1e-9, 1 + 2e-9),
        Eigen::Vector3d(1e-6, 1e-6 + 1e-15, 1), Eigen::Vector3d(1e-12, 1, 1 + 1e-12)})
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::Matrix3d axes = RandomRotation(generator);
      ExpectDecomposes(axes * values.asDiagonal() * axes.transpose());
    }
}

TEST(DecomposeSymmetric, SurvivesScalesOfAnySize) {
  std::mt19937 generator(3);
  for (const double scale : {1e-150, 1e-12, 1e-5, 1e12, 1e150}) {
    const Eigen::Matrix3d axes = RandomRotation(generator);
    ExpectDecomposes(scale * (axes * Eigen::Vector3d(1, 3, 10).asDiagonal() * axes.transpose()));
  }
}

TEST(DecomposeSymmetric, SortsDiagonalsAndTakesZero) {
  ExpectDecomposes(Eigen::Vector3d(3, 1, 2).asDiagonal());
  ExpectDecomposes(Eigen::Vector3d(2, 3, 1).asDiagonal());
  ExpectDecomposes(Eigen::Matrix3d::Identity());
  const SymmetricEigen3 zero = DecomposeSymmetric({});
  EXPECT_EQ(zero.values, (std::array<double, 3>{0, 0, 0}));
}

TEST(DecomposeSymmetric, SurvivesOffDiagonalValuesThatNearlyVanish) {
  for (const double tiny : {1e-300, 1e-160, 1e-17, 1e-12}) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix(0, 1) = matrix(1, 0) = tiny;
    ExpectDecomposes(matrix);
    matrix.diagonal() << 1, 2, 3;
    ExpectDecomposes(matrix);
  }
}

}  // namespace
}  // namespace fallen
