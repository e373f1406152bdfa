// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "fallen/classification/cluster_classification.hpp"

namespace fallen {
namespace {

constexpr double kCell = 0.05;

OrientedBox BoxAround(const std::vector<Eigen::Vector3f>& means) {
  SegmentedMap map;
  map.cell_size_m = kCell;
  CellCluster cluster;
  for (const Eigen::Vector3f& mean : means) {
    cluster.cells.push_back(static_cast<std::int32_t>(map.cells.size()));
    map.cells.emplace_back().mean = mean;
  }
  return FitUprightBox(map, cluster);
}

double AreaAt(const std::vector<Eigen::Vector3f>& means, double yaw) {
  const Eigen::Vector2d x(std::cos(yaw), std::sin(yaw)), y(-std::sin(yaw), std::cos(yaw));
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector3f& mean : means) {
    const Eigen::Vector2d p = mean.head<2>().cast<double>();
    low = low.min(Eigen::Array2d(x.dot(p), y.dot(p)));
    high = high.max(Eigen::Array2d(x.dot(p), y.dot(p)));
  }
  return (high - low + kCell).prod();
}

TEST(FitUprightBox, FindsATurnedRectangle) {
  for (const double degrees : {-89.0, -45.0, -10.0, 0.0, 30.0, 75.0, 90.0}) {
    const double yaw = degrees * std::numbers::pi / 180;
    const Eigen::AngleAxisd turn(yaw, Eigen::Vector3d::UnitZ());
    std::vector<Eigen::Vector3f> means;
    for (const double x : {-0.9, 0.0, 0.9})
      for (const double y : {-0.2, 0.2})
        for (const double z : {0.1, 0.4})
          means.push_back(
              (turn * Eigen::Vector3d(x, y, z) + Eigen::Vector3d(3, -2, 0)).cast<float>());
    const OrientedBox box = BoxAround(means);
    EXPECT_LT((box.center - Eigen::Vector3d(3, -2, 0.25)).norm(), 1e-5);
    EXPECT_LT((box.size - Eigen::Vector3d(1.85, 0.45, 0.35)).norm(), 1e-5);
    EXPECT_NEAR(std::abs(std::cos(box.yaw - yaw)), 1, 1e-9);
    EXPECT_GT(box.yaw, -std::numbers::pi / 2);
    EXPECT_LE(box.yaw, std::numbers::pi / 2);
  }
}

TEST(FitUprightBox, IsAsSmallAsAnyYawAllowsAndHoldsAllCells) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Eigen::Vector3f> means;
    const int count = 1 + static_cast<int>(random() % 60);
    for (int i = 0; i < count; ++i)
      means.emplace_back(normal(random) + 40, normal(random) * 0.3F - 40, normal(random) * 0.2F);
    const OrientedBox box = BoxAround(means);
    for (const Eigen::Vector3f& mean : means) EXPECT_TRUE(box.Contains(mean.cast<double>()));
    EXPECT_GE(box.size.x(), box.size.y());
    double smallest = 1e9;
    for (int i = 0; i < 1800; ++i)
      smallest = std::min(smallest, AreaAt(means, i * std::numbers::pi / 3600));
    EXPECT_LE(box.size.head<2>().prod(), smallest + 1e-9);
    EXPECT_NEAR(box.size.head<2>().prod(), AreaAt(means, box.yaw), 1e-9);
  }
}

TEST(FitUprightBox, TakesOneCellAndCellsOnALine) {
  const OrientedBox one = BoxAround({{1, 2, 3}});
  EXPECT_LT((one.center - Eigen::Vector3d(1, 2, 3)).norm(), 1e-9);
  EXPECT_LT((one.size - Eigen::Vector3d::Constant(kCell)).norm(), 1e-9);
  EXPECT_EQ(BoxAround({{1, 2, 3}, {1, 2, 3}}), one);

  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i <= 4; ++i)
    line.emplace_back(0.25F * static_cast<float>(i), 0.25F * static_cast<float>(i), 0.0F);
  const OrientedBox box = BoxAround(line);
  EXPECT_NEAR(box.yaw, std::numbers::pi / 4, 1e-9);
  EXPECT_NEAR(box.size.x(), std::sqrt(2.0) + kCell, 1e-6);
  EXPECT_NEAR(box.size.y(), kCell, 1e-6);
}

TEST(FitUprightBox, RejectsAClusterWithoutCells) {
  EXPECT_THROW(FitUprightBox(SegmentedMap{}, CellCluster{}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
