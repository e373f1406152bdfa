// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fallen/classification/cluster_classification.hpp"

namespace fallen {
namespace {

constexpr float kCell = 0.05F;

void AddCell(SegmentedMap& map, const Eigen::Vector3f& mean, bool is_member, float score) {
  ScoredCell scored;
  scored.cell.mean = mean;
  scored.cell.covariance = {4e-4F, 0, 0, 2e-4F, 0, 1e-5F};  // a level patch
  scored.score = score;
  if (is_member) map.clusters[0].cells.push_back(static_cast<std::int32_t>(map.cells.size()));
  map.cells.push_back(scored);
}

// A slab 2 m long and 0.5 m wide, turned by `yaw`, its cells at 0.1 m and at 0.2 m above the floor;
// the half with x > 0 has the upper layer only, so the other half is the heavier one.
SegmentedMap Slab(float yaw) {
  SegmentedMap map;
  map.frame = MapFrame::kWorld;
  map.ground.status = GroundStatus::kOk;
  map.ground.plane = {Eigen::Vector3d::UnitZ(), 0};
  map.T_map_camera.translation() = Eigen::Vector3d(0, -3, 1.2);
  map.clusters.resize(1);
  const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
  for (int layer = 1; layer <= 2; ++layer)
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 10; ++k) {
        if (layer == 1 && i >= 20) continue;
        const Eigen::Vector3f mean((static_cast<float>(i) - 19.5F) * kCell,
                                   (static_cast<float>(k) - 4.5F) * kCell,
                                   0.1F * static_cast<float>(layer));
        AddCell(map, turn * mean, true, layer == 1 ? 0.25F : 0.75F);
      }
  return map;
}

Eigen::RowVectorXf Features(const SegmentedMap& map) {
  const Eigen::VectorXd code = Eigen::Vector3d(0.1, 0.2, 0.3);
  return ComputeClusterFeatures(map, map.clusters[0], FitUprightBox(map, map.clusters[0]), code,
                                std::exp(2.0));
}

TEST(ClusterFeatures, MeasureSizeHeightAndOutline) {
  const Eigen::RowVectorXf f = Features(Slab(0));
  ASSERT_EQ(f.size(), kClusterShapeFeatures + 3);
  EXPECT_TRUE(f.allFinite());
  EXPECT_NEAR(f[0], std::log(600), 1e-5);
  EXPECT_NEAR(f[1], (200 * 0.25 + 400 * 0.75) / 600, 1e-5);
  EXPECT_NEAR(f[2], 0.75, 1e-6);
  EXPECT_NEAR(f[4], 2, 1e-6);
  EXPECT_NEAR(f[5], 0.1, 1e-6);
  EXPECT_NEAR(f[6], (200 * 0.1 + 400 * 0.2) / 600, 1e-5);
  EXPECT_NEAR(f[7], 0.2, 1e-6);
  EXPECT_NEAR(f[11], 2, 1e-4);  // a cell more than the means span
  EXPECT_NEAR(f[12], 0.5, 1e-4);
  EXPECT_NEAR(f[13], 0.15, 1e-5);
  EXPECT_NEAR(f[14], 0.25, 1e-4);
  EXPECT_NEAR(f[18], f[17] / (2 * 0.5), 1e-4);
  EXPECT_NEAR(f[19], 1, 1e-4);  // all normals are upright
  EXPECT_NEAR(f[24], 3, 1e-4);
  EXPECT_NEAR(f[25], 1.2, 1e-6);
  EXPECT_EQ(f[46], 200.0F / 600);  // the lower layer
  EXPECT_FLOAT_EQ(f[kClusterShapeFeatures + 2], 0.3F);
}

TEST(ClusterFeatures, ProfileBeginsAtTheHeavierHalf) {
  for (const float yaw : {0.0F, 0.6F, 3.1415927F}) {
    const Eigen::RowVectorXf f = Features(Slab(yaw));
    const float first = f[31], last = f[31 + 3 * 4];
    EXPECT_GT(first, last) << yaw;
    float sum = 0;
    for (int slice = 0; slice < 5; ++slice) {
      sum += f[31 + 3 * slice];
      EXPECT_NEAR(f[32 + 3 * slice], 0.2, 1e-5);
      EXPECT_NEAR(f[33 + 3 * slice], 0.45, 0.01);
    }
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

TEST(ClusterFeatures, DoNotDependOnWhereTheClusterLies) {
  const Eigen::RowVectorXf here = Features(Slab(0));
  const Eigen::RowVectorXf turned = Features(Slab(0.6F));
  for (const int column : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 19})
    EXPECT_NEAR(here[column], turned[column], 1e-3) << column;
}

TEST(ClusterFeatures, CountWhatStandsAround) {
  SegmentedMap map = Slab(0);
  AddCell(map, {0, 0.3F, 0.15F}, false, 0.5F);   // touches the side
  AddCell(map, {0, 0.3F, 0.16F}, false, -0.5F);  // too
  AddCell(map, {0, 0, 0.5F}, false, 0);          // above
  AddCell(map, {0, 0, 0.05F}, false, 0);         // below
  AddCell(map, {0, 0.5F, 0.15F}, false, 0);      // beside
  AddCell(map, {0, 0.5F, 0.15F}, false, 0);
  AddCell(map, {0, 0.5F, 0.15F}, false, 0);
  AddCell(map, {0, 2, 0.15F}, false, 0);  // far
  AddCell(map, {0, 0, 1}, false, 0);      // far above
  const Eigen::RowVectorXf f = Features(map);
  EXPECT_FLOAT_EQ(f[26], 2.0F / 600);
  EXPECT_FLOAT_EQ(f[27], 1.0F / 600);
  EXPECT_FLOAT_EQ(f[28], 1.0F / 600);
  EXPECT_FLOAT_EQ(f[29], 3.0F / 600);
  EXPECT_NEAR(f[30], 0, 1e-6);
}

TEST(ClusterFeatures, AreFiniteForOneCell) {
  SegmentedMap map = Slab(0);
  map.clusters[0].cells.resize(1);
  EXPECT_TRUE(Features(map).allFinite());
}

TEST(ClusterFeatures, RejectEmptyClustersAndMapsWithoutFloor) {
  SegmentedMap map = Slab(0);
  const OrientedBox box = FitUprightBox(map, map.clusters[0]);
  const Eigen::VectorXd code = Eigen::VectorXd::Zero(3);
  EXPECT_THROW(ComputeClusterFeatures(map, CellCluster{}, box, code, 1), std::invalid_argument);
  map.ground.status = GroundStatus::kNoFloorInView;
  EXPECT_THROW(ComputeClusterFeatures(map, map.clusters[0], box, code, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
