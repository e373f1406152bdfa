// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/layer_features.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fallen {
namespace {

// Two layers of 10 cm, two bins: 3 * 2 + 3 columns each.
BaselineConfig SmallConfig() {
  BaselineConfig config;
  config.layers = 2;
  config.layer_height_m = 0.1;
  config.normal_bins = 2;
  config.leaf_m = 0.05;
  return config;
}
constexpr int kColumns = 9;

// Four points 1 m apart along x in the lower layer, two in the upper one.
SurfaceCloud SmallCluster() {
  SurfaceCloud cluster;
  cluster.points = {{-1.5F, 2, 0.05F}, {-0.5F, 2, 0.05F}, {0.5F, 2, 0.05F},
                    {1.5F, 2, 0.05F},  {0, 2.25F, 0.15F}, {0, 1.75F, 0.15F}};
  const float half = std::sqrt(0.5F);
  cluster.normals = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {0, half, half}, {0, -half, half}};
  return cluster;
}

void ExpectColumns(const Eigen::RowVectorXf& features, int first,
                   const std::vector<float>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(features[first + static_cast<int>(i)], expected[i], 1e-5F)
        << "column " << first + static_cast<int>(i);
}

TEST(LayerFeatures, AreWhatOneCountsByHand) {
  const Eigen::RowVectorXf features = ComputeLayerFeatures(SmallCluster(), 1.2, SmallConfig());
  ASSERT_EQ(features.size(), 2 * kColumns + kClusterGeometryFeatures);
  ASSERT_EQ(features.size(), LayerFeatureCount(SmallConfig()));
  const float third = 1.0F / 3;
  // The main axis is x. Of three normals one lies along x, one along y, one along z; the fourth
  // point has none.
  ExpectColumns(features, 0, {2 * third, third, 2 * third, third, 0, 1, 4.0F / 6, 3, 0});
  ExpectColumns(features, kColumns, {1, 0, 0, 1, 0, 1, 2.0F / 6, 0, 0.5F});
  const float mean = (4 * 0.05F + 2 * 0.15F) / 6;
  const float deviation = std::sqrt((4 * 0.0025F + 2 * 0.0225F) / 6 - mean * mean);
  ExpectColumns(features, 2 * kColumns,
                {6 * 0.0025F, 3, 0.5F, 0.1F, 0.05F, mean, deviation, 0.05F, 0.15F,
                 std::sqrt((2 * 2.25F + 2 * 0.25F) / 6), std::sqrt(2 * 0.0625F / 6), 2, 1.2F});
}

TEST(LayerFeatures, DoNotDependOnWhereAPersonLiesAboutTheVertical) {
  SurfaceCloud turned = SmallCluster();
  const Eigen::Matrix3f R = Eigen::AngleAxisf(2.1F, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  for (Eigen::Vector3f& p : turned.points) p = R * p;
  for (Eigen::Vector3f& n : turned.normals) n = R * n;
  // Normals of 45 degrees and zero components would lie on edges of bins: three bins have none.
  BaselineConfig config = SmallConfig();
  config.normal_bins = 3;
  const auto before = ComputeLayerFeatures(SmallCluster(), 1, config);
  EXPECT_TRUE(ComputeLayerFeatures(turned, 1, config).isApprox(before, 1e-4F));
}

TEST(LayerFeatures, HighestLayerHasNoUpperEndAndPointsBelowTheFloorAreInTheLowest) {
  SurfaceCloud cluster;
  cluster.points = {{1, 0, 7}, {1, 0, -0.3F}};
  cluster.normals = {{0, 0, 1}, {0, 0, -1}};
  const auto features = ComputeLayerFeatures(cluster, 1, SmallConfig());
  ExpectColumns(features, 4, {1, 0, 0.5F});
  ExpectColumns(features, kColumns + 4, {0, 1, 0.5F});
}

TEST(LayerFeatures, OnePointIsFiniteAndNoneIsRefused) {
  SurfaceCloud cluster{{{1, 2, 0.1F}}, {{0, 0, 1}}};
  EXPECT_TRUE(ComputeLayerFeatures(cluster, 1, BaselineConfig{}).allFinite());
  cluster.normals.clear();
  EXPECT_THROW(ComputeLayerFeatures(cluster, 1, BaselineConfig{}), std::invalid_argument);
  EXPECT_THROW(ComputeLayerFeatures({}, 1, BaselineConfig{}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
