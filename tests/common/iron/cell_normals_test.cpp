// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "fallen/iron/iron_descriptor.hpp"

namespace fallen {
namespace {

NdtCell CellWith(const Eigen::Matrix3f& covariance) {
  NdtCell cell;
  cell.covariance = {covariance(0, 0), covariance(0, 1), covariance(0, 2),
                     covariance(1, 1), covariance(1, 2), covariance(2, 2)};
  return cell;
}

CellNormal NormalOf(const Eigen::Matrix3f& covariance) {
  const std::vector<NdtCell> cells = {CellWith(covariance)};
  return ComputeNormals(cells).front();
}

TEST(CellNormals, FindTheDirectionThatACellWasBuiltWith) {
  std::mt19937 generator(1);
  std::normal_distribution<float> gaussian;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Matrix3f axes = Eigen::Quaternionf(gaussian(generator), gaussian(generator),
                                                    gaussian(generator), gaussian(generator))
                                     .normalized()
                                     .toRotationMatrix();
    const Eigen::Vector3f eigenvalues(1e-6f, 8e-5f, 2e-4f);
    const CellNormal normal = NormalOf(axes * eigenvalues.asDiagonal() * axes.transpose());
    ASSERT_TRUE(normal.usable);
    EXPECT_NEAR(normal.normal.norm(), 1, 1e-5);
    EXPECT_NEAR(std::abs(normal.normal.dot(axes.col(0))), 1, 1e-5);
    EXPECT_TRUE(normal.eigenvalues.isApprox(eigenvalues, 1e-3f)) << normal.eigenvalues;
  }
}

TEST(CellNormals, LeaveOutBallsAndNeedles) {
  const auto usable = [](float a, float b, float c) {
    return NormalOf(Eigen::Vector3f(a, b, c).asDiagonal()).usable;
  };
  EXPECT_TRUE(usable(1e-6f, 1e-4f, 1e-4f)) << "a disc";
  EXPECT_TRUE(usable(0.89e-4f, 1e-4f, 2e-4f)) << "just no ball";
  EXPECT_FALSE(usable(0.91e-4f, 1e-4f, 2e-4f)) << "just a ball";
  EXPECT_TRUE(usable(1e-6f, 1.01e-5f, 1e-4f)) << "just no needle";
  EXPECT_FALSE(usable(1e-6f, 0.99e-5f, 1e-4f)) << "just a needle";
  EXPECT_FALSE(usable(1e-4f, 1e-4f, 1e-4f)) << "a perfect ball";
  EXPECT_FALSE(usable(0, 0, 1e-4f)) << "points on a line";
  EXPECT_TRUE(usable(0, 1e-4f, 1e-4f)) << "points in a plane";
  EXPECT_FALSE(usable(0, 0, 0)) << "points on one spot";
}

TEST(CellNormals, LeaveOutCellsThatAreNotFinite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const NdtCell good = CellWith(Eigen::Vector3f(1e-6f, 1e-4f, 2e-4f).asDiagonal());
  // Each of a cell's nine values in turn, good cells between them.
  std::vector<NdtCell> cells;
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity})
    for (int k = 0; k < 9; ++k) {
      NdtCell cell = good;
      (k < 3 ? cell.mean[k] : cell.covariance[k - 3]) = bad;
      cells.insert(cells.end(), {cell, good});
    }
  const std::vector<CellNormal> normals = ComputeNormals(cells);
  ASSERT_EQ(normals.size(), 54U);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const bool is_good = i % 2 == 1;
    EXPECT_EQ(normals[i].usable, is_good) << i;
    EXPECT_EQ(normals[i].normal.isZero(0), !is_good) << i;
    EXPECT_EQ(normals[i].eigenvalues.isZero(0), !is_good) << i;
  }
}

TEST(CellNormals, OfNothingAreNothing) { EXPECT_TRUE(ComputeNormals({}).empty()); }

}  // namespace
}  // namespace fallen
