// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/environment_builder.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

/// Points of one voxel of 5 cm that begins at `corner`, spread as a tilted patch.
std::vector<Eigen::Vector3d> PatchIn(const Eigen::Vector3d& corner, int count,
                                     std::uint64_t seed = 1) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> place(0.002, 0.048);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double x = place(generator);
    const double y = place(generator);
    points.push_back(corner + Eigen::Vector3d(x, y, 0.01 + 0.4 * x + 0.2 * y));
  }
  return points;
}

EnvironmentMap BuildOf(const std::vector<Eigen::Vector3d>& points) {
  EnvironmentBuilder builder({});
  for (const Eigen::Vector3d& point : points) builder.AddPoint(point);
  return builder.Build();
}

TEST(EnvironmentBuilder, ACellHasTheMeanAndCovarianceOfItsPoints) {
  // Also 10 km from the origin, where sums of squares in floats would have lost the covariance.
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(1, -2.05, 0.3), Eigen::Vector3d(10000, -2.05, 0.3)}) {
    const std::vector<Eigen::Vector3d> points = PatchIn(corner, 50);
    const EnvironmentMap map = BuildOf(points);
    ASSERT_EQ(map.cells.size(), 1u);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) mean += point / 50;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : points)
      covariance += (point - mean) * (point - mean).transpose() / 49;
    const NdtCell& cell = map.cells.front();
    EXPECT_EQ(cell.point_count, 50u);
    // A float near 10 km tells 1 mm apart; 1e-6 m^2 is a hundredth of the largest variance here.
    EXPECT_LT((cell.mean.cast<double>() - mean).norm(), corner.norm() * 1e-7 + 1e-7);
    EXPECT_LT((cell.CovarianceMatrix().cast<double>() - covariance).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(EnvironmentBuilder, CellsOfTwoSourcesMergeAsTheirPointsWould) {
  const Eigen::Vector3d corner(1, 2, 0.5);
  std::vector<Eigen::Vector3d> both = PatchIn(corner, 30, 1);
  const std::vector<Eigen::Vector3d> second = PatchIn(corner, 20, 2);
  EnvironmentBuilder builder({});
  builder.AddCells(BuildOf(both).cells);
  builder.AddCells(BuildOf(second).cells);
  both.insert(both.end(), second.begin(), second.end());

  const std::vector<NdtCell> merged = builder.Build().cells;
  const std::vector<NdtCell> expected = BuildOf(both).cells;
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged[0].point_count, 50u);
  EXPECT_TRUE(merged[0].mean.isApprox(expected[0].mean, 1e-6f));
  EXPECT_LT((merged[0].CovarianceMatrix() - expected[0].CovarianceMatrix()).cwiseAbs().maxCoeff(),
            1e-8f);
}

TEST(EnvironmentBuilder, CellsArePositiveDefiniteWhateverThePoints) {
  std::vector<Eigen::Vector3d> points(10, Eigen::Vector3d(0.01, 0.01, 0.5));       // one spot
  for (int i = 0; i < 10; ++i) points.emplace_back(1.001 + 0.004 * i, 0.01, 0.5);  // a line
  for (const NdtCell& cell : BuildOf(points).cells) {
    const Eigen::LLT<Eigen::Matrix3f> cholesky(cell.CovarianceMatrix());
    EXPECT_EQ(cholesky.info(), Eigen::Success) << cell.mean.transpose();
  }
}

TEST(EnvironmentBuilder, LeavesOutThinVoxelsAndWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Vector3d> points = PatchIn({0, 0, 1}, 3);  // min_points is 4
  points.insert(points.end(), 9, {nan, 0, 0});
  points.insert(points.end(), 9, {1e9, 0, 0});
  EXPECT_TRUE(BuildOf(points).cells.empty());
  EXPECT_TRUE(BuildOf({}).cells.empty());
}

TEST(EnvironmentBuilder, TheOrderOfTheInputChangesNothingInTheOrderOfTheCells) {
  std::vector<Eigen::Vector3d> points;
  for (const double x : {3.0, -1.0, 2.0})
    for (const Eigen::Vector3d& point : PatchIn({x, 0, 1}, 8)) points.push_back(point);
  const std::vector<NdtCell> forward = BuildOf(points).cells;
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const std::vector<NdtCell> sorted = BuildOf(points).cells;
  ASSERT_EQ(forward.size(), 3u);
  ASSERT_EQ(sorted.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_LT((forward[i].mean - sorted[i].mean).norm(), 1e-6f);
}

TEST(EnvironmentBuilder, RefusesAConfigurationOutOfRange) {
  EXPECT_THROW(EnvironmentBuilder({.cell_size_m = 0}), std::invalid_argument);
  EXPECT_THROW(EnvironmentBuilder({.min_points = 0}), std::invalid_argument);
  EXPECT_THROW(EnvironmentBuilder({.min_eigenvalue_ratio = 2}), std::invalid_argument);
  EXPECT_THROW(EnvironmentBuilder({.min_eigenvalue_ratio = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
