// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/voxel_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace fallen {
namespace {

Eigen::Matrix3d Full(const SymmetricMatrix3& m) {
  Eigen::Matrix3d full;
  full << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  return full;
}

Eigen::Matrix3Xd RandomOffsets(int count, const Eigen::Vector3d& deviation, int seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> gaussian;
  Eigen::Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) points(k, i) = deviation[k] * gaussian(generator);
  return points;
}

PointSums<double> SumsOf(const Eigen::Matrix3Xd& points) {
  PointSums<double> sums;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    sums.Add(points(0, i), points(1, i), points(2, i));
  return sums;
}

void ExpectMomentsOf(const Eigen::Matrix3Xd& points, const Moments& moments) {
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.colwise() - mean;
  const Eigen::Matrix3d covariance =
      centred * centred.transpose() / static_cast<double>(points.cols() - 1);
  EXPECT_EQ(moments.count, static_cast<double>(points.cols()));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moments.mean[k], mean[k], 1e-12);
  EXPECT_TRUE(Full(moments.Covariance()).isApprox(covariance, 1e-9));
}

TEST(VoxelStatistics, OnePassEqualsTwoPasses) {
  const Eigen::Matrix3Xd points = RandomOffsets(500, {0.01, 0.005, 0.0002}, 1);
  ExpectMomentsOf(points, MomentsOf(SumsOf(points)));
}

TEST(VoxelStatistics, MergingEqualsTheUnion) {
  Eigen::Matrix3Xd points = RandomOffsets(300, {0.01, 0.005, 0.0002}, 2);
  points.rightCols(200).colwise() += Eigen::Vector3d(0.01, -0.01, 0.02);
  const Moments merged =
      Merge(MomentsOf(SumsOf(points.leftCols(100))), MomentsOf(SumsOf(points.rightCols(200))));
  ExpectMomentsOf(points, merged);
}

TEST(VoxelStatistics, MergingWithNothingChangesNothing) {
  const Moments some = MomentsOf(SumsOf(RandomOffsets(10, {0.01, 0.01, 0.01}, 3)));
  EXPECT_EQ(Merge(some, Moments{}).scatter, some.scatter);
  EXPECT_EQ(Merge(Moments{}, some).scatter, some.scatter);
  EXPECT_EQ(Merge(Moments{}, Moments{}).count, 0);
}

TEST(VoxelStatistics, LimitingTheCountKeepsTheDistribution) {
  Moments moments = MomentsOf(SumsOf(RandomOffsets(1000, {0.01, 0.005, 0.001}, 4)));
  const Moments before = moments;
  LimitCount(moments, 50);
  EXPECT_EQ(moments.count, 50);
  EXPECT_EQ(moments.mean, before.mean);
  EXPECT_TRUE(Full(moments.Covariance()).isApprox(Full(before.Covariance()), 1e-12));
  LimitCount(moments, 100);
  EXPECT_EQ(moments.count, 50) << "never scaled up";
}

TEST(VoxelStatistics, TooFewPointsHaveNoCovariance) {
  EXPECT_EQ(Moments{}.Covariance(), SymmetricMatrix3{});
  EXPECT_EQ(MomentsOf(SumsOf(RandomOffsets(1, {1, 1, 1}, 5))).Covariance(), SymmetricMatrix3{});
}

TEST(VoxelStatistics, FlooredEigenvaluesKeepTheirAxes) {
  const Eigen::Matrix3d axes = Eigen::Quaterniond(1, 2, -1, 0.5).normalized().toRotationMatrix();
  const auto floored = [&](const Eigen::Vector3d& values) -> Eigen::Vector3d {
    const Eigen::Matrix3d full = axes * values.asDiagonal() * axes.transpose();
    const SymmetricMatrix3 result = FloorEigenvalues(
        {full(0, 0), full(0, 1), full(0, 2), full(1, 1), full(1, 2), full(2, 2)}, 1e-3);
    return (axes.transpose() * Full(result) * axes).diagonal();
  };
  const auto expect_floored = [&](const Eigen::Vector3d& values, const Eigen::Vector3d& expected) {
    EXPECT_LT((floored(values) - expected).cwiseAbs().maxCoeff(), 1e-15) << values.transpose();
  };
  expect_floored({1e-5, 1e-4, 2e-4}, {1e-5, 1e-4, 2e-4});
  expect_floored({3e-7, 1e-4, 2e-4}, {3e-7, 1e-4, 2e-4});
  expect_floored({1e-8, 1e-4, 2e-4}, {2e-7, 1e-4, 2e-4});
  expect_floored({0, 0, 2e-4}, {2e-7, 2e-7, 2e-4});
  expect_floored({0, 0, 0}, {1e-9, 1e-9, 1e-9});
  expect_floored({-1e-18, 1e-12, 1e-8}, {1e-9, 1e-9, 1e-8});
}

// What a cell's message demands: Sylvester's criterion on the stored numbers.
TEST(VoxelStatistics, TheLeastRatioStaysPositiveDefiniteInSinglePrecision) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 2000; ++round) {
    const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
    const Eigen::Matrix3d axes = turn.normalized().toRotationMatrix();
    // A disc or a line through a voxel of a metre: the largest that there is.
    const Eigen::Vector3d values(0, round % 2 == 0 ? 0.25 : 0, 0.25);
    const Eigen::Matrix3d full = axes * values.asDiagonal() * axes.transpose();
    const SymmetricMatrix3 floored =
        FloorEigenvalues({full(0, 0), full(0, 1), full(0, 2), full(1, 1), full(1, 2), full(2, 2)},
                         kLeastEigenvalueRatio);
    const Eigen::Matrix3d stored = Full(floored).cast<float>().cast<double>();
    ASSERT_GT(stored(0, 0), 0);
    ASSERT_GT(stored.topLeftCorner(2, 2).determinant(), 0);
    ASSERT_GT(stored.determinant(), 0) << round;
  }
}

TEST(VoxelStatistics, ACovarianceAboveTheFloorIsNotTouched) {
  for (int seed = 0; seed < 50; ++seed) {
    const SymmetricMatrix3 covariance =
        MomentsOf(SumsOf(RandomOffsets(30, {0.01, 0.005, 0.001}, seed))).Covariance();
    EXPECT_EQ(FloorEigenvalues(covariance, 1e-3), covariance);
  }
}

}  // namespace
}  // namespace fallen
