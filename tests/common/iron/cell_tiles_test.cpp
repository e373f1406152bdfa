// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/cell_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace fallen {
namespace {

std::vector<Eigen::Vector3f> RandomPoints(int count, float size_m, const Eigen::Vector3f& center) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-size_m / 2, size_m / 2);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i)
    points.push_back(center + Eigen::Vector3f(uniform(random), uniform(random), uniform(random)));
  return points;
}

// Every base is in one tile, and what is found near its tile holds all its neighbours.
void ExpectComplete(const std::vector<Eigen::Vector3f>& points,
                    const std::vector<std::uint8_t>& is_base, float radius_m) {
  CellTiles tiles;
  tiles.Build(points, is_base, 0.5F);
  const std::span<const Eigen::Vector3f> sorted = tiles.grid().sorted_points();
  std::vector<std::uint8_t> seen(points.size(), 0);
  for (const CellTile& tile : tiles.tiles()) {
    ASSERT_LE(tiles.bases_of(tile).size(), static_cast<std::size_t>(kMostLanes));
    const std::span<const std::int32_t> near = tiles.FindNear(tile, radius_m);
    for (const std::int32_t base : tiles.bases_of(tile)) {
      ++seen[tiles.grid().sorted_index()[base]];
      int found = 0, expected = 0;
      for (const std::int32_t k : near)
        found += (sorted[k] - sorted[base]).squaredNorm() <= radius_m * radius_m;
      for (const Eigen::Vector3f& point : points)
        expected += (point - sorted[base]).squaredNorm() <= radius_m * radius_m;
      ASSERT_EQ(found, expected);
    }
  }
  EXPECT_EQ(seen, is_base);
}

TEST(CellTiles, HoldAllNeighboursOfEachBase) {
  const std::vector<Eigen::Vector3f> points = RandomPoints(2000, 3, {1, 2, 3});
  ExpectComplete(points, std::vector<std::uint8_t>(points.size(), 1), 0.5F);
  ExpectComplete(points, std::vector<std::uint8_t>(points.size(), 1), 0.2F);
}

TEST(CellTiles, TakeSomeBasesAndCellsFarApart) {
  std::vector<Eigen::Vector3f> points = RandomPoints(600, 2, {-300, 40, 0});
  const std::vector<Eigen::Vector3f> far = RandomPoints(50, 200, {0, 0, 0});
  points.insert(points.end(), far.begin(), far.end());
  std::vector<std::uint8_t> is_base(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) is_base[i] = i % 3 == 0;
  ExpectComplete(points, is_base, 0.5F);
}

TEST(CellTiles, TakeNoCellsAndNoBases) {
  ExpectComplete({}, {}, 0.5F);
  ExpectComplete(RandomPoints(5, 1, {0, 0, 0}), std::vector<std::uint8_t>(5, 0), 0.5F);
}

TEST(CellTiles, StayTheSameWhereTheirMemoryWasUsed) {
  const std::vector<Eigen::Vector3f> points = RandomPoints(900, 2, {0, 0, 0});
  const std::vector<std::uint8_t> all(points.size(), 1);
  CellTiles fresh, used;
  used.Build(RandomPoints(2000, 5, {1, 1, 1}), std::vector<std::uint8_t>(2000, 1), 0.4F);
  used.Build(points, all, 0.5F);
  fresh.Build(points, all, 0.5F);
  ASSERT_EQ(used.tiles().size(), fresh.tiles().size());
  EXPECT_TRUE(std::ranges::equal(used.bases(), fresh.bases()));
  for (std::size_t t = 0; t < used.tiles().size(); ++t)
    ASSERT_TRUE(std::ranges::equal(used.FindNear(used.tiles()[t], 0.5F),
                                   fresh.FindNear(fresh.tiles()[t], 0.5F)));
}

}  // namespace
}  // namespace fallen
