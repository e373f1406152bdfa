// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fallen/segmentation/cell_segmentation.hpp"
#include "flat_cell.hpp"

namespace fallen {
namespace {

constexpr int kDescriptor = 48;

// A table top at 0.7 m over a box whose top is at 0.2 m and which reaches out on one side, seen
// from a floor that lies at z = -1; one wall cell beside them.
NdtMap Scene() {
  NdtMap map;
  map.frame = MapFrame::kWorld;
  map.ground.status = GroundStatus::kOk;
  map.ground.plane.offset = 1;
  const auto add_plate = [&](float x_begin, float z) {
    for (int x = 0; x < 16; ++x)
      for (int y = 0; y < 16; ++y)
        map.cells.push_back(
            FlatCell({x_begin + 0.05F * static_cast<float>(x), 0.05F * static_cast<float>(y), z}));
  };
  add_plate(0, -0.3F);
  add_plate(0.6F, -0.8F);
  map.cells.push_back(FlatCell({0.2F, 0.9F, 0.2F}, {1, 0, 0}));
  return map;
}

FeatureMatrix FeaturesOf(const NdtMap& map, CellFeatureSet features) {
  const std::vector<CellNormal> normals = ComputeNormals(map.cells);
  std::vector<std::int32_t> all(map.cells.size());
  std::iota(all.begin(), all.end(), 0);
  return ComputeCellFeatures(map, normals, ComputeIronDescriptors(map.cells, normals), all,
                             features);
}

TEST(ComputeCellFeatures, BeginsWithTheDescriptor) {
  const NdtMap map = Scene();
  const IronDescriptors descriptors = ComputeIronDescriptors(map.cells, ComputeNormals(map.cells));
  const FeatureMatrix iron = FeaturesOf(map, CellFeatureSet::kIron);
  const FeatureMatrix both = FeaturesOf(map, CellFeatureSet::kIronAndShape);
  EXPECT_EQ(iron, descriptors.values);
  EXPECT_EQ(both.leftCols(kDescriptor), descriptors.values);
  EXPECT_EQ(iron.cols(), CellFeatureCount({}, CellFeatureSet::kIron));
  EXPECT_EQ(both.cols(), CellFeatureCount({}, CellFeatureSet::kIronAndShape));
}

TEST(ComputeCellFeatures, DescribesShapeAndHeight) {
  const FeatureMatrix all = FeaturesOf(Scene(), CellFeatureSet::kIronAndShape);
  const FeatureMatrix features = all.rightCols(kShapeFeatureCount);
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    EXPECT_NEAR(features(i, 0), 0.002 * 0.002 / (0.015 * 0.015), 1e-4);
    EXPECT_NEAR(features(i, 1), 1, 1e-4);
    EXPECT_NEAR(features(i, 2), 0.015, 1e-5);
    EXPECT_NEAR(features(i, 4), i == 512 ? 0 : 1, 1e-4);
    EXPECT_NEAR(features(i, 3), i < 256 ? 0.7 : i < 512 ? 0.2 : 1.2, 1e-5);
  }
  // The middle of a plate of cells: every place of the disc is taken, on the other plate some too.
  const Eigen::Index middle = 8 * 16 + 8;
  EXPECT_GT(all(middle, kDescriptor), 0.5F);
  EXPECT_LT(all(middle, kDescriptor), 2.0F);
}

TEST(ComputeCellFeatures, DescribesWhatStandsAround) {
  const FeatureMatrix features =
      FeaturesOf(Scene(), CellFeatureSet::kIronAndShape).rightCols(kShapeFeatureCount);
  // The table's far corner: nothing below it.
  EXPECT_NEAR(features(0, 5), 0, 1e-5);
  EXPECT_NEAR(features(0, 6), 0, 1e-5);
  // The table over the box.
  const Eigen::Index over = 12 * 16 + 4;
  EXPECT_NEAR(features(over, 5), 0, 1e-5);
  EXPECT_NEAR(features(over, 6), 0.5, 1e-5);
  // The box under the table.
  const Eigen::Index under = 256 + 2 * 16 + 4;
  EXPECT_NEAR(features(under, 5), 0.5, 1e-5);
  EXPECT_NEAR(features(under, 6), 0, 1e-5);
  EXPECT_NEAR(features(under, 7), 0.7, 1e-5);
  EXPECT_GT(features(under, 8), 0.2F);
  EXPECT_LT(features(under, 8), 0.7F);
  // The box's far corner, clear of the table: a quarter of its disc is covered.
  const Eigen::Index corner = 256 + 15 * 16;
  EXPECT_NEAR(features(corner, 7), 0.2, 1e-5);
  EXPECT_NEAR(features(corner, 9), 0.3, 0.1);
  // The wall cell rises above the table within its reach.
  EXPECT_NEAR(features(512, 5), 0, 1e-5);
  EXPECT_NEAR(features(512, 7), 1.2, 1e-5);
}

TEST(ComputeCellFeatures, StaysFiniteWithoutAFloor) {
  NdtMap map = Scene();
  map.ground.status = GroundStatus::kNoFloorInView;
  const FeatureMatrix features =
      FeaturesOf(map, CellFeatureSet::kIronAndShape).rightCols(kShapeFeatureCount);
  EXPECT_TRUE(features.allFinite());
  EXPECT_TRUE(features.rightCols(7).isZero(0));
  EXPECT_GT(features.topLeftCorner(512, 3).minCoeff(), 0);
}

TEST(ComputeCellFeatures, TakesRowsInTheOrderOfTheIndicesAndNone) {
  const NdtMap map = Scene();
  const std::vector<CellNormal> normals = ComputeNormals(map.cells);
  const IronDescriptors descriptors = ComputeIronDescriptors(map.cells, normals);
  const auto with = [&](const std::vector<std::int32_t>& indices) {
    return ComputeCellFeatures(map, normals, descriptors, indices, CellFeatureSet::kIronAndShape);
  };
  const FeatureMatrix all = FeaturesOf(map, CellFeatureSet::kIronAndShape);
  const FeatureMatrix some = with({300, 5});
  EXPECT_EQ(some.row(0), all.row(300));
  EXPECT_EQ(some.row(1), all.row(5));
  EXPECT_EQ(with({}).rows(), 0);
  EXPECT_EQ(with({}).cols(), kDescriptor + 1 + kShapeFeatureCount);
}

TEST(ComputeCellFeatures, RejectsSizesAndIndicesThatDoNotFit) {
  const NdtMap map = Scene();
  const std::vector<CellNormal> normals = ComputeNormals(map.cells);
  const IronDescriptors descriptors = ComputeIronDescriptors(map.cells, normals);
  const auto rejects = [&](const NdtMap& m, const std::vector<CellNormal>& n,
                           const std::vector<std::int32_t>& indices) {
    EXPECT_THROW(ComputeCellFeatures(m, n, descriptors, indices, CellFeatureSet::kIron),
                 std::invalid_argument);
  };
  rejects(NdtMap{}, normals, {0});
  rejects(map, {}, {0});
  rejects(map, normals, {-1});
  rejects(map, normals, {static_cast<std::int32_t>(map.cells.size())});
}

}  // namespace
}  // namespace fallen
