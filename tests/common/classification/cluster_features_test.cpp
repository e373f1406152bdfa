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
  if (is_member) {
    map.clusters[0].cells.push_back(static_cast<std::int32_t>(map.cells.size()));
    map.members.push_back({mean, {4e-4F, 0, 0, 2e-4F, 0, 1e-5F}});  // a level patch
  }
  map.cells.push_back({mean, score, is_member ? 0 : -1});
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

// Descriptors of the members: 1/4 and 3/4 in their first value, by turns.
void Describe(SegmentedMap& map) {
  CellCluster& cluster = map.clusters[0];
  cluster.descriptors = IronDescriptors::Matrix::Zero(
      static_cast<Eigen::Index>(cluster.cells.size()), map.iron.dimension());
  for (Eigen::Index row = 0; row < cluster.descriptors.rows(); ++row)
    cluster.descriptors(row, 0) = row % 2 == 0 ? 0.25F : 0.75F;
}

const Eigen::VectorXd kCode = Eigen::Vector3d(0.1, 0.2, 0.3);

Eigen::RowVectorXf Features(SegmentedMap map) {
  Describe(map);
  const CellCluster& cluster = map.clusters[0];
  const OrientedBox box = FitUprightBox(map, cluster);
  return ComputeClusterFeatures(ClusterScene(map), cluster, box, {cluster, box}, kCode,
                                std::exp(2.0));
}

TEST(ClusterFeatures, MeasureSizeHeightAndOutline) {
  const Eigen::RowVectorXf f = Features(Slab(0));
  ASSERT_EQ(f.size(), kClusterShapeFeatures + 2 * 48 + 3);
  ASSERT_EQ(f.size(), ClusterFeatureCount({}, 3));
  EXPECT_TRUE(f.allFinite());
  EXPECT_NEAR(f[0], std::log(600), 1e-5);
  EXPECT_NEAR(f[1], 2, 1e-6);
  EXPECT_NEAR(f[2], 0.1, 1e-6);
  EXPECT_NEAR(f[3], (200 * 0.1 + 400 * 0.2) / 600, 1e-5);
  EXPECT_NEAR(f[4], 0.2, 1e-6);
  EXPECT_NEAR(f[5], std::sqrt(2.0) / 3 * 0.1, 1e-5);
  EXPECT_NEAR(f[6], 0.1, 1e-6);
  EXPECT_NEAR(f[7], 0.2, 1e-6);
  EXPECT_NEAR(f[8 + 1], 200.0 / 600, 1e-6);  // 6 to 12 cm
  EXPECT_NEAR(f[8 + 3], 400.0 / 600, 1e-6);  // 18 to 24 cm
  EXPECT_NEAR(f[20], 200.0 / 600, 1e-6);     // the lower layer
  EXPECT_NEAR(f[21], 2, 1e-4);               // a cell more than the means span
  EXPECT_NEAR(f[22], 0.5, 1e-4);
  EXPECT_NEAR(f[23], 0.15, 1e-5);
  EXPECT_NEAR(f[24], 0.25, 1e-4);
  EXPECT_NEAR(f[26], 0.05 * std::sqrt((100 - 1) / 12.0), 1e-4);
  EXPECT_NEAR(f[28], f[27] / (2 * 0.5), 1e-4);
  EXPECT_NEAR(f[92], 3, 1e-2);
  EXPECT_NEAR(f[93], 1.2, 1e-6);
  EXPECT_NEAR(f[94], 0, 0.01);
}

TEST(ClusterFeatures, MeasureScoresSurfaceAndDescriptors) {
  const Eigen::RowVectorXf f = Features(Slab(0));
  EXPECT_NEAR(f[81], 0.25, 1e-6);
  EXPECT_NEAR(f[84], 0.75, 1e-6);
  EXPECT_NEAR(f[88], 0.75, 1e-6);
  EXPECT_NEAR(f[89], (200 * 0.25 + 400 * 0.75) / 600, 1e-5);
  EXPECT_NEAR(f[91], 200 * 0.25 + 400 * 0.75, 1e-3);
  EXPECT_NEAR(f[95 + 3], 200.0 / 600, 1e-5);  // level patches under 0.12 m
  EXPECT_NEAR(f[95 + 7], 400.0 / 600, 1e-5);  // and under 0.3 m
  EXPECT_NEAR(f.segment(107, 4).sum(), 0, 1e-6);
  EXPECT_NEAR(f[111], 1, 1e-4);
  EXPECT_NEAR(f[112], 1, 1e-4);
  EXPECT_NEAR(f[113], 1e-5 / 2e-4, 1e-4);
  EXPECT_NEAR(f[114], 0.5, 1e-4);
  EXPECT_NEAR(f[116], std::sqrt(1e-5), 1e-5);
  EXPECT_NEAR(f[kClusterShapeFeatures], 0.5, 1e-5);
  EXPECT_NEAR(f[kClusterShapeFeatures + 48], 0.25, 1e-5);
  EXPECT_FLOAT_EQ(f[kClusterShapeFeatures + 96 + 2], 0.3F);
}

TEST(ClusterFeatures, ProfileEndsAtTheHigherHalf) {
  for (const float yaw : {0.0F, 0.6F, 3.1415927F}) {
    const Eigen::RowVectorXf f = Features(Slab(yaw));
    // The upper layer alone is the higher half in the mean; it has half of the cells.
    EXPECT_NEAR(f[29], 2 * f[29 + 6 * 5], 0.05) << yaw;
    float sum = 0;
    for (int slice = 0; slice < 6; ++slice) {
      sum += f[29 + 6 * slice];
      EXPECT_NEAR(f[30 + 6 * slice], 0.2, 1e-5);
      EXPECT_NEAR(f[32 + 6 * slice], 0.45, 0.02);
      EXPECT_NEAR(f[33 + 6 * slice], 0, 0.02);
    }
    EXPECT_NEAR(f[31], 0.15, 0.01);
    EXPECT_NEAR(f[31 + 6 * 5], 0.2, 1e-5);
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_NEAR(f.segment(65, 8).sum(), 600, 1e-3);
    EXPECT_NEAR(f[73 + 3], 0.2, 1e-5);
  }
}

TEST(ClusterFeatures, DoNotDependOnWhereTheClusterLies) {
  const Eigen::RowVectorXf here = Features(Slab(0));
  const Eigen::RowVectorXf turned = Features(Slab(0.6F));
  for (int column = 0; column < kClusterShapeFeatures; ++column) {
    // A raster and steps have their edges somewhere; the camera looks from elsewhere.
    const bool is_raster = column == 27 || column == 28 || (column >= 29 && column < 81) ||
                           (column >= 92 && column < 95) || column == 143 || column == 144;
    if (is_raster) continue;
    EXPECT_NEAR(here[column], turned[column], 2e-3) << column;
  }
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
  EXPECT_FLOAT_EQ(f[120], 2.0F / 600);
  EXPECT_FLOAT_EQ(f[121], 1.0F / 600);
  EXPECT_FLOAT_EQ(f[122], 1.0F / 600);
  EXPECT_FLOAT_EQ(f[123], 3.0F / 600);
  EXPECT_NEAR(f[124], 0, 1e-6);
  EXPECT_FLOAT_EQ(f[125], 8.0F / 600);  // all but the far one
  EXPECT_FLOAT_EQ(f[126], 1.0F / 600);  // above 0.5 m
  EXPECT_FLOAT_EQ(f[127], 1);
  EXPECT_FLOAT_EQ(f[128], 0.5F);
}

TEST(ClusterFeatures, MeasureLayers) {
  const Eigen::RowVectorXf f = Features(Slab(0));
  const auto lower = f.segment(146 + 8 * 2, 8);  // 10 to 15 cm: the half
  EXPECT_EQ(lower[0], 200);
  EXPECT_NEAR(lower[1], 19 * kCell, 1e-4);
  EXPECT_NEAR(lower[2], 9 * kCell, 1e-4);
  EXPECT_NEAR(lower[6], 1, 1e-4);
  EXPECT_NEAR(lower[7], std::sqrt(1e-5), 1e-5);
  const auto upper = f.segment(146 + 8 * 4, 8);  // 20 to 25 cm: all of it
  EXPECT_EQ(upper[0], 400);
  EXPECT_NEAR(upper[1], 39 * kCell, 1e-4);
  EXPECT_NEAR(upper[4], 0.05 * std::sqrt((100 - 1) / 12.0), 1e-4);
  // The mean of the upper layer lies a sixth of the length away from the mean of all cells.
  EXPECT_NEAR(upper[5], 20 * kCell / 6, 1e-2);
  EXPECT_EQ(f.segment(146, 16).norm(), 0);
  EXPECT_EQ(f.segment(146 + 8 * 5, 40).norm(), 0);
}

TEST(ClusterFeatures, TellAPartWhatItIsAPartOf) {
  SegmentedMap map = Slab(0);
  Describe(map);
  const CellCluster& whole = map.clusters[0];
  const OrientedBox whole_box = FitUprightBox(map, whole);
  CellCluster part;
  part.cells.assign(whole.cells.begin(), whole.cells.begin() + 150);
  part.descriptors = whole.descriptors.topRows(150);
  const Eigen::RowVectorXf f = ComputeClusterFeatures(
      ClusterScene(map), part, FitUprightBox(map, part), {whole, whole_box}, kCode, 1);
  EXPECT_NEAR(f[0], std::log(150), 1e-5);
  EXPECT_NEAR(f[137], std::log(600), 1e-5);
  EXPECT_NEAR(f[138], (200 * 0.25 + 400 * 0.75) / 600, 1e-5);
  EXPECT_NEAR(f[139], 0.2, 1e-6);
  EXPECT_NEAR(f[140], 2, 1e-4);
  EXPECT_NEAR(f[145], 0.25, 1e-6);
  EXPECT_EQ(Features(map)[145], 1);
}

TEST(ClusterFeatures, AreFiniteForOneCell) {
  SegmentedMap map = Slab(0);
  map.clusters[0].cells.resize(1);
  EXPECT_TRUE(Features(map).allFinite());
}

TEST(ClusterFeatures, RejectEmptyClustersAndMapsWithoutFloor) {
  SegmentedMap map = Slab(0);
  const OrientedBox box = FitUprightBox(map, map.clusters[0]);
  const CellCluster none;
  EXPECT_THROW(
      ComputeClusterFeatures(ClusterScene(map), none, box, {map.clusters[0], box}, kCode, 1),
      std::invalid_argument);
  map.ground.status = GroundStatus::kNoFloorInView;
  EXPECT_THROW((ClusterScene(map)), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
