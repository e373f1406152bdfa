// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/eigenvalue_floor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fallen/ndt/voxel_statistics.hpp"
#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

constexpr double kRatio = 1e-3;

SymmetricMatrix3 Turned(const Eigen::Vector3d& eigenvalues, const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d R = rotation.toRotationMatrix();
  const Eigen::Matrix3d m = R * eigenvalues.asDiagonal() * R.transpose();
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

// Flat, long, round and empty ones, turned anywhere and along the axes.
std::vector<SymmetricMatrix3> Covariances() {
  std::mt19937 random(1);
  std::normal_distribution<double> gaussian;
  std::vector<SymmetricMatrix3> all;
  for (const Eigen::Vector3d& values :
       {Eigen::Vector3d(0, 1e-4, 2e-4), Eigen::Vector3d(0, 2e-4, 2e-4), Eigen::Vector3d(0, 0, 2e-4),
        Eigen::Vector3d(1e-8, 1e-8, 2e-4), Eigen::Vector3d(2e-4, 2e-4, 2e-4),
        Eigen::Vector3d(1e-4, 2e-4, 3e-4), Eigen::Vector3d(1e-12, 1e-11, 1e-10),
        Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 1, 4)})
    for (int turn = 0; turn < 20; ++turn) {
      Eigen::Quaterniond rotation(gaussian(random), gaussian(random), gaussian(random),
                                  gaussian(random));
      rotation.normalize();
      if (turn == 0) rotation = Eigen::Quaterniond::Identity();
      if (turn == 1) rotation = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX());
      if (turn == 2) rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
      all.push_back(Turned(values, rotation));
    }
  return all;
}

std::vector<SymmetricMatrix3> FlooredInLanes(const std::vector<SymmetricMatrix3>& matrices) {
  std::vector<SymmetricMatrix3> floored;
  for (std::size_t begin = 0; begin < matrices.size(); begin += CovarianceLanes::kCount) {
    CovarianceLanes lanes;
    const std::size_t count =
        std::min<std::size_t>(CovarianceLanes::kCount, matrices.size() - begin);
    for (std::size_t lane = 0; lane < count; ++lane)
      for (std::size_t k = 0; k < 6; ++k) lanes.coefficients[k][lane] = matrices[begin + lane][k];
    FloorEigenvalueLanes(lanes, kRatio);
    for (std::size_t lane = 0; lane < count; ++lane) {
      SymmetricMatrix3& result = floored.emplace_back();
      for (std::size_t k = 0; k < 6; ++k) result[k] = lanes.coefficients[k][lane];
    }
  }
  return floored;
}

// What is raised is known to the eigenvalues' absolute error, 1e-15 of the largest.
TEST(FloorEigenvalueLanes, GivesWhatOneMatrixAfterTheOtherDoes) {
  const std::vector<SymmetricMatrix3> matrices = Covariances();
  std::vector<SymmetricMatrix3> portable;
  test::AtEverySimdLevel([&](SimdLevel level) {
    const std::vector<SymmetricMatrix3> floored = FlooredInLanes(matrices);
    if (level == SimdLevel::kPortable) portable = floored;
    EXPECT_EQ(floored, portable);
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      const SymmetricMatrix3 expected = FloorEigenvalues(matrices[i], kRatio);
      const double largest = std::max({matrices[i][0], matrices[i][3], matrices[i][5]});
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(floored[i][k], expected[k], 1e-14 * largest + 1e-24) << i << " " << k;
    }
  });
}

}  // namespace
}  // namespace fallen
