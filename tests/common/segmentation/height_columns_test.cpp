// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/height_columns.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "flat_cell.hpp"

namespace fallen {
namespace {

// Two cells 2 m apart in x and y set the raster; all others stand in the middle of its columns.
std::vector<NdtCell> CellsInColumns(int count, unsigned seed,
                                    std::vector<Eigen::Vector2i>& places) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> height(0, 1.5F);
  std::vector<NdtCell> cells{FlatCell({0, 0, 0.3F}), FlatCell({1.999F, 1.999F, 0.7F})};
  places = {{0, 0}, {19, 19}};
  for (int i = 0; i < count; ++i) {
    places.emplace_back(static_cast<int>(random() % 20), static_cast<int>(random() % 20));
    const Eigen::Vector2f middle = (places.back().cast<float>().array() + 0.5F) * 0.1F;
    cells.push_back(FlatCell({middle.x(), middle.y(), height(random)}));
  }
  return cells;
}

TEST(HeightColumns, SummarizesTheColumnsOfADiscLikeASearchOverAllCells) {
  std::vector<Eigen::Vector2i> places;
  const std::vector<NdtCell> cells = CellsInColumns(150, 1, places);
  const HeightColumns columns(cells, Plane{});
  for (const auto& [radius, sq_columns, disc] :
       {std::tuple{0.25F, 6.25, 21}, std::tuple{0.5F, 25.0, 81}})
    for (std::size_t i = 0; i < cells.size(); ++i) {
      float low = 9, high = -9;
      double sum = 0;
      int count = 0;
      std::vector<std::pair<int, int>> occupied;
      for (std::size_t k = 0; k < cells.size(); ++k) {
        if ((places[k] - places[i]).squaredNorm() > sq_columns) continue;
        low = std::min(low, cells[k].mean.z());
        high = std::max(high, cells[k].mean.z());
        sum += cells[k].mean.z();
        ++count;
        occupied.emplace_back(places[k].x(), places[k].y());
      }
      std::sort(occupied.begin(), occupied.end());
      const auto distinct = std::unique(occupied.begin(), occupied.end()) - occupied.begin();
      const ColumnSummary summary = columns.Summarize(i, radius);
      EXPECT_EQ(summary.lowest_m, low);
      EXPECT_EQ(summary.highest_m, high);
      EXPECT_NEAR(summary.mean_m, sum / count, 1e-5);
      EXPECT_NEAR(summary.occupied_share, static_cast<double>(distinct) / disc, 1e-6);
    }
}

TEST(HeightColumns, MeasuresHeightsAlongATiltedFloor) {
  std::vector<Eigen::Vector2i> places;
  std::vector<NdtCell> cells = CellsInColumns(100, 2, places);
  const HeightColumns level(cells, Plane{});
  const Eigen::Isometry3d T_tilted_level =
      Eigen::Translation3d(5, -300, 20) *
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.8, 0.1).normalized());
  for (NdtCell& cell : cells) cell.mean = (T_tilted_level * cell.mean.cast<double>()).cast<float>();
  const HeightColumns tilted(cells, TransformPlane(T_tilted_level, Plane{}));
  for (std::size_t i = 0; i < cells.size(); ++i)
    EXPECT_NEAR(tilted.height_m(i), level.height_m(i), 1e-4);  // floats of 300 m: 3e-5 m
}

TEST(HeightColumns, TakesNoCellsOneCellAndCellsFarApart) {
  EXPECT_NO_THROW(HeightColumns({}, Plane{}));
  const std::vector<NdtCell> one{FlatCell({3, 4, 0.5F})};
  const ColumnSummary summary = HeightColumns(one, Plane{}).Summarize(0, 0.5F);
  EXPECT_EQ(summary.lowest_m, 0.5F);
  EXPECT_EQ(summary.highest_m, 0.5F);
  EXPECT_EQ(summary.mean_m, 0.5F);
  EXPECT_NEAR(summary.occupied_share, 1.0 / 81, 1e-6);
  const std::vector<NdtCell> far{FlatCell({-1e6F, -1e6F, 0.5F}), FlatCell({1e6F, 1e6F, 0.25F})};
  EXPECT_EQ(HeightColumns(far, Plane{}).Summarize(1, 0.5F).highest_m, 0.25F);
}

TEST(HeightColumns, RejectsCellsThatAreNotFinite) {
  const std::vector<NdtCell> broken{FlatCell({0, std::nanf(""), 0})};
  EXPECT_THROW(HeightColumns(broken, Plane{}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
