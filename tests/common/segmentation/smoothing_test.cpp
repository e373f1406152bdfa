// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/smoothing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

using Points = std::vector<Eigen::Vector3f>;

TEST(SmoothScores, IsTheMeanOverAllPairsWithinTheRadius) {
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
  const NeighborGrid grid(points, 0.25F);
  for (const float radius : {0.15F, 0.3F, 5.0F}) {
    const std::vector<float> smoothed = SmoothScores(grid, points, scores, valid, radius);
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

TEST(SmoothScores, LeavesScoresAloneWithoutARadius) {
  const Points points{{0, 0, 0}, {0.1F, 0, 0}};
  const std::vector<float> scores{0.5F, -0.25F};
  const NeighborGrid grid(points, 0.1F);
  EXPECT_EQ(SmoothScores(grid, points, scores, std::vector<std::uint8_t>{1, 1}, 0), scores);
}

TEST(SmoothScores, TakesNoPoints) {
  const NeighborGrid grid({}, 0.1F);
  EXPECT_TRUE(SmoothScores(grid, {}, {}, {}, 0.15F).empty());
}

TEST(SmoothScores, RejectsSizesThatDisagreeAndBrokenRadii) {
  const Points points{{0, 0, 0}};
  const NeighborGrid grid(points, 0.1F);
  const std::vector<float> score{1.0F};
  const std::vector<std::uint8_t> valid{1};
  EXPECT_THROW(SmoothScores(grid, points, {}, valid, 0.1F), std::invalid_argument);
  EXPECT_THROW(SmoothScores(grid, points, score, {}, 0.1F), std::invalid_argument);
  EXPECT_THROW(SmoothScores(grid, {}, {}, {}, 0.1F), std::invalid_argument);
  EXPECT_THROW(SmoothScores(grid, points, score, valid, -0.1F), std::invalid_argument);
  EXPECT_THROW(SmoothScores(grid, points, score, valid, std::nanf("")), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
