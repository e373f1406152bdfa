// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/cells_near_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fallen/simd/lanes.hpp"
#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

constexpr BoxSurroundings kBox = {{-0.1F, 0.2F, 1.0F}, {0.1F, 0.3F, 1.2F}, 0.25F};

struct Points {
  std::vector<float> x, y, z;
  PointColumns columns() const { return {x.data(), y.data(), z.data()}; }
};

Points RandomPoints(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Points points;
  for (int i = 0; i < count + kMostLanes; ++i) {
    points.x.push_back(uniform(random));
    points.y.push_back(uniform(random));
    points.z.push_back(1 + uniform(random));
  }
  return points;
}

float SquareDistance(const Points& points, int k) {
  const auto gap = [](float p, float low, float high) {
    return std::max({low - p, p - high, 0.0F});
  };
  const float dx = gap(points.x[k], kBox.low[0], kBox.high[0]);
  const float dy = gap(points.y[k], kBox.low[1], kBox.high[1]);
  const float dz = gap(points.z[k], kBox.low[2], kBox.high[2]);
  return dx * dx + dy * dy + dz * dz;
}

std::vector<std::int32_t> Find(const Points& points, const std::vector<CellRun>& runs) {
  std::vector<std::int32_t> positions(points.x.size() + kMostLanes);
  const int count = FindNearBox(points.columns(), runs.data(), static_cast<int>(runs.size()), kBox,
                                positions.data());
  positions.resize(count);
  return positions;
}

TEST(CellsNearBox, AreThoseOfTheRunsWithinTheRadiusAtEveryLevel) {
  const Points points = RandomPoints(500);
  const std::vector<CellRun> runs = {{0, 1}, {3, 3}, {7, 40}, {41, 57}, {100, 500}};
  std::vector<std::int32_t> expected;
  for (const CellRun& run : runs)
    for (int k = run.begin; k < run.end; ++k)
      if (SquareDistance(points, k) <= kBox.sq_radius) expected.push_back(k);
  ASSERT_GT(expected.size(), 30u);
  ASSERT_LT(expected.size(), 300u);
  test::AtEverySimdLevel([&](SimdLevel level) {
    EXPECT_EQ(Find(points, runs), expected) << "level " << static_cast<int>(level);
  });
}

// Distances at which rounding decides: a point is kept if it is near any corner of the box.
TEST(CellsNearBox, LoseNoPointThatIsNearACornerToTheLastBit) {
  Points points = RandomPoints(4000);
  const auto put_on_sphere = [&](int k) {
    const float length = std::sqrt(points.x[k] * points.x[k] + points.y[k] * points.y[k] +
                                   (points.z[k] - 1) * (points.z[k] - 1));
    points.x[k] = kBox.high[0] + 0.5F * std::abs(points.x[k]) / length;
    points.y[k] = kBox.high[1] + 0.5F * std::abs(points.y[k]) / length;
    points.z[k] = kBox.high[2] + 0.5F * std::abs(points.z[k] - 1) / length;
  };
  for (int k = 0; k < 4000; ++k) put_on_sphere(k);
  std::vector<std::uint8_t> is_found(4000, 0);
  for (const std::int32_t k : Find(points, {{0, 4000}})) is_found[k] = 1;
  int near = 0;
  for (int k = 0; k < 4000; ++k) {
    const float dx = kBox.high[0] - points.x[k], dy = kBox.high[1] - points.y[k],
                dz = kBox.high[2] - points.z[k];
    if (dx * dx + dy * dy + dz * dz > kBox.sq_radius) continue;
    ++near;
    EXPECT_TRUE(is_found[k]);
  }
  EXPECT_GT(near, 1000);
  EXPECT_LT(near, 3000);
}

}  // namespace
}  // namespace fallen
