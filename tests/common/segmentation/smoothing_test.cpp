// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/smoothing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

using Points = std::vector<Eigen::Vector3f>;

CellTiles TilesOf(const Points& points) {
  CellTiles tiles;
  tiles.Build(points, std::vector<std::uint8_t>(points.size(), 1), 0.5F);
  return tiles;
}

std::vector<float> Smooth(const Points& points, const std::vector<float>& scores,
                          const std::vector<std::uint8_t>& valid, float radius_m) {
  CellTiles tiles = TilesOf(points);
  return ScoreSmoother().Smooth(tiles, scores, valid, radius_m);
}

TEST(ScoreSmoother, IsTheMeanOverAllPairsWithinTheRadius) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Points points;
  std::vector<float> scores;
  std::vector<std::uint8_t> valid;
  for (int i = 0; i < 600; ++i) {
    points.emplace_back(uniform(random), uniform(random), uniform(random));
    scores.push_back(uniform(random));
    valid.push_back(random() % 4 != 0);
  }
  for (const float radius : {0.15F, 0.3F, 5.0F}) {
    const std::vector<float> smoothed = Smooth(points, scores, valid, radius);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double sum = 0;
      int count = 0;
      for (std::size_t j = 0; j < points.size(); ++j)
        if (valid[j] && (points[i] - points[j]).squaredNorm() <= radius * radius) {
          sum += scores[j];
          ++count;
        }
      // Summation order differs: a few units in the last place of a float.
      EXPECT_NEAR(smoothed[i], valid[i] ? sum / count : 0.0, 1e-6);
    }
  }
}

TEST(ScoreSmoother, GivesTheSameBitsAtEverySimdLevel) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Points points;
  std::vector<float> scores;
  for (int i = 0; i < 500; ++i) {
    points.emplace_back(uniform(random), uniform(random), uniform(random));
    scores.push_back(uniform(random));
  }
  const std::vector<std::uint8_t> all(points.size(), 1);
  std::vector<float> portable;
  test::AtEverySimdLevel([&](SimdLevel level) {
    const std::vector<float> smoothed = Smooth(points, scores, all, 0.4F);
    if (level == SimdLevel::kPortable) portable = smoothed;
    EXPECT_EQ(smoothed, portable) << "level " << static_cast<int>(level);
  });
}

TEST(ScoreSmoother, LeavesScoresAloneWithoutARadius) {
  const Points points{{0, 0, 0}, {0.1F, 0, 0}};
  const std::vector<float> scores{0.5F, -0.25F};
  EXPECT_EQ(Smooth(points, scores, {1, 1}, 0), scores);
}

TEST(ScoreSmoother, TakesNoPoints) { EXPECT_TRUE(Smooth({}, {}, {}, 0.15F).empty()); }

TEST(ScoreSmoother, RejectsSizesThatDisagreeAndBrokenRadii) {
  const Points points{{0, 0, 0}};
  const std::vector<float> score{1.0F};
  const std::vector<std::uint8_t> valid{1};
  EXPECT_THROW(Smooth(points, {}, valid, 0.1F), std::invalid_argument);
  EXPECT_THROW(Smooth(points, score, {}, 0.1F), std::invalid_argument);
  EXPECT_THROW(Smooth(points, score, valid, -0.1F), std::invalid_argument);
  EXPECT_THROW(Smooth(points, score, valid, std::nanf("")), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
