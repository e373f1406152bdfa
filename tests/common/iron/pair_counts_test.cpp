// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

struct Scene {
  BaseLanes bases{};
  std::vector<PairCell> cells;
  std::vector<std::int32_t> near;
};

// `count` cells with random normals, most of them near; the first kMostLanes - 3 are the bases.
Scene RandomScene(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-0.5F, 0.5F);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3f normal(uniform(random), uniform(random), uniform(random));
    if (i % 3 == 0) normal = Eigen::Vector3f::UnitZ();  // many equal normals, as on a wall
    normal.normalize();
    scene.cells.push_back(
        {uniform(random), uniform(random), uniform(random), normal.x(), normal.y(), normal.z()});
  }
  scene.cells[5] = scene.cells[4];  // equal means
  scene.bases.x.fill(kNowhere);
  scene.bases.y.fill(kNowhere);
  scene.bases.z.fill(kNowhere);
  for (int lane = 0; lane < kMostLanes - 3; ++lane) {
    const PairCell& cell = scene.cells[lane];
    scene.bases.x[lane] = cell.x;
    scene.bases.y[lane] = cell.y;
    scene.bases.z[lane] = cell.z;
    scene.bases.normal_x[lane] = PairBinning::kNormalScale * cell.normal_x;
    scene.bases.normal_y[lane] = PairBinning::kNormalScale * cell.normal_y;
    scene.bases.normal_z[lane] = PairBinning::kNormalScale * cell.normal_z;
  }
  for (int k = 0; k < count; ++k)
    if (k < count / 3 || k >= count / 2) scene.near.push_back(k);
  return scene;
}

// One pair after the other.
std::vector<std::uint32_t> PlainCounts(const Scene& scene, const PairBinning& binning) {
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(2 * binning.rows * binning.columns) *
                                    kMostLanes);
  const auto square = [](float c) { return c * std::abs(c); };
  for (int lane = 0; lane < kMostLanes; ++lane)
    for (const std::int32_t j : scene.near) {
      const PairCell& cell = scene.cells[j];
      const Eigen::Vector3f line(scene.bases.x[lane] - cell.x, scene.bases.y[lane] - cell.y,
                                 scene.bases.z[lane] - cell.z);
      const Eigen::Vector3f normal(scene.bases.normal_x[lane], scene.bases.normal_y[lane],
                                   scene.bases.normal_z[lane]);
      const float sq_distance = line.x() * line.x() + line.y() * line.y() + line.z() * line.z();
      if (sq_distance > binning.sq_radius) continue;
      const float between =
          normal.x() * cell.normal_x + normal.y() * cell.normal_y + normal.z() * cell.normal_z;
      const float along = normal.x() * line.x() + normal.y() * line.y() + normal.z() * line.z();
      const int row = binning.RowOf(sq_distance);
      const int column0 = binning.ColumnOf(square(between));
      const int column1 = binning.ColumnOf(square(along) / std::max(sq_distance, kLeastSquare));
      ++counts[PairCountIndex(row, 0, column0, binning.columns) + lane];
      ++counts[PairCountIndex(row, 1, column1, binning.columns) + lane];
    }
  return counts;
}

void ExpectPlainCountsAtEveryLevel(const Scene& scene, const IronConfig& config,
                                   NormalSigns signs = NormalSigns::kArbitrary) {
  const PairBinning binning(config, signs);
  const ColumnTables tables(binning);
  const std::vector<std::uint32_t> expected = PlainCounts(scene, binning);
  test::AtEverySimdLevel([&](SimdLevel level) {
    std::vector<std::uint32_t> counts(expected.size());
    CountPairs(scene.bases, scene.cells.data(), scene.near.data(),
               static_cast<int>(scene.near.size()), binning, tables, counts.data());
    EXPECT_EQ(counts, expected) << "level " << static_cast<int>(level);
  });
}

TEST(CountPairs, GivesThePlainCountsAtEveryLevel) {
  ExpectPlainCountsAtEveryLevel(RandomScene(300, 1), {});
  IronConfig wide;
  wide.radius_m = 2;  // every pair, so that counters of few bits fill up
  ExpectPlainCountsAtEveryLevel(RandomScene(9000, 2), wide);
}

TEST(CountPairs, FillsOneCounterToTheBrim) {
  IronConfig wide;
  wide.radius_m = 2;
  Scene plane = RandomScene(9000, 5);
  for (PairCell& cell : plane.cells) {
    cell.z = 0;
    cell.normal_x = cell.normal_y = 0;
    cell.normal_z = 1;
  }
  plane.bases.z.fill(0);
  plane.bases.normal_x.fill(0);
  plane.bases.normal_y.fill(0);
  plane.bases.normal_z.fill(PairBinning::kNormalScale);
  ExpectPlainCountsAtEveryLevel(plane, wide);
}

TEST(CountPairs, TakesOtherHistogramsThanThePapers) {
  for (const int rows : {1, 2, 3, 5})
    for (const int columns : {1, 2, 3, 7, 8, 9, 32}) {
      IronConfig config;
      config.distance_bins = rows;
      config.angle_bins = columns;
      ExpectPlainCountsAtEveryLevel(RandomScene(120, 3), config);
    }
}

TEST(CountPairs, TakesAnglesUpTo180Degrees) {
  for (const int columns : {1, 2, 7, 8, 16}) {
    IronConfig config;
    config.angle_bins = columns;
    ExpectPlainCountsAtEveryLevel(RandomScene(120, 4), config, NormalSigns::kOriented);
  }
}

TEST(PairBinning, PutsAnglesUpTo180DegreesIntoTheirColumns) {
  IronConfig config;
  for (const int columns : {7, 8}) {
    config.angle_bins = columns;
    const PairBinning binning(config, NormalSigns::kOriented);
    for (int k = 0; k < columns; ++k) {
      const float middle = (static_cast<float>(k) + 0.5F) / static_cast<float>(columns);
      const float c = PairBinning::kNormalScale * std::cos(middle * std::numbers::pi_v<float>);
      EXPECT_EQ(binning.ColumnOf(c * std::abs(c)), k);
    }
  }
}

TEST(CountPairs, HasTablesForThePapersHistograms) {
  EXPECT_TRUE(ColumnTables(PairBinning(IronConfig{})).valid);
  EXPECT_FALSE(ColumnTables(PairBinning(IronConfig{}, NormalSigns::kOriented)).valid);
}

}  // namespace
}  // namespace fallen
