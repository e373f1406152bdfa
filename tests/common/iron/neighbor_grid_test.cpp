// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/neighbor_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

std::vector<Eigen::Vector3f> RandomPoints(int count, float size_m, const Eigen::Vector3f& center,
                                          int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-size_m / 2, size_m / 2);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i)
    points.push_back(center +
                     Eigen::Vector3f(uniform(generator), uniform(generator), uniform(generator)));
  return points;
}

std::vector<int> Found(const NeighborGrid& grid, const Eigen::Vector3f& query, float radius_m) {
  std::vector<int> found;
  grid.ForEachWithin(query, radius_m, [&](int index, float) { found.push_back(index); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> BruteForce(const std::vector<Eigen::Vector3f>& points,
                            const Eigen::Vector3f& query, float radius_m) {
  std::vector<int> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i] - query).squaredNorm() <= radius_m * radius_m)
      found.push_back(static_cast<int>(i));
  return found;
}

void ExpectAgreesWithBruteForce(const std::vector<Eigen::Vector3f>& points, float bucket_m,
                                float radius_m) {
  const NeighborGrid grid(points, bucket_m);
  ASSERT_EQ(grid.size(), points.size());
  for (const Eigen::Vector3f& point : points) {
    ASSERT_EQ(Found(grid, point, radius_m), BruteForce(points, point, radius_m));
    const Eigen::Vector3f outside = point + Eigen::Vector3f(0.7f * radius_m, -2 * radius_m, 0);
    ASSERT_EQ(Found(grid, outside, radius_m), BruteForce(points, outside, radius_m));
  }
}

TEST(NeighborGrid, AgreesWithBruteForce) {
  ExpectAgreesWithBruteForce(RandomPoints(500, 2, {0, 0, 0}, 1), 0.5f, 0.5f);
  ExpectAgreesWithBruteForce(RandomPoints(500, 2, {0, 0, 0}, 2), 0.25f, 0.5f);
  ExpectAgreesWithBruteForce(RandomPoints(500, 2, {0, 0, 0}, 3), 1.0f, 0.13f);
  ExpectAgreesWithBruteForce(RandomPoints(200, 2, {0, 0, 0}, 4), 0.25f, 5.0f);
}

TEST(NeighborGrid, AgreesWithBruteForceFarFromTheOrigin) {
  ExpectAgreesWithBruteForce(RandomPoints(400, 2, {1000, -5000, 80}, 5), 0.25f, 0.5f);
}

// On a lattice, neighbours lie exactly on the rim and buckets begin exactly at points.
TEST(NeighborGrid, LosesNoPointOnTheRim) {
  for (const float offset : {0.0f, 0.1f, 1000.0f}) {
    std::vector<Eigen::Vector3f> points;
    for (int x = 0; x < 9; ++x)
      for (int y = 0; y < 9; ++y)
        for (int z = 0; z < 4; ++z) {
          const Eigen::Vector3f step = 0.25f * Eigen::Vector3i(x, y, z).cast<float>();
          points.push_back(step + Eigen::Vector3f(offset, -offset, 0));
        }
    ExpectAgreesWithBruteForce(points, 0.25f, 0.5f);
    ExpectAgreesWithBruteForce(points, 0.1f, 0.25f);
  }
}

TEST(NeighborGrid, WidensItsBucketsForPointsFarApart) {
  std::vector<Eigen::Vector3f> points = RandomPoints(50, 2, {0, 0, 0}, 6);
  points.emplace_back(1e6f, -1e6f, 1e6f);
  points.emplace_back(-9e8f, 9e8f, 9e8f);
  const NeighborGrid grid(points, 0.01f);
  for (const Eigen::Vector3f& point : points)
    ASSERT_EQ(Found(grid, point, 0.5f), BruteForce(points, point, 0.5f));
}

NearestPoint PlainNearest(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& query,
                          float radius_m) {
  NearestPoint nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float sq_distance = (points[i] - query).squaredNorm();
    if (sq_distance <= radius_m * radius_m && sq_distance < nearest.sq_distance)
      nearest = {static_cast<std::int32_t>(i), sq_distance};
  }
  return nearest;
}

// Each point twice, so that two are always as near.
TEST(NeighborGrid, FindsTheNearestAsBruteForceDoes) {
  for (const Eigen::Vector3f& center :
       {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1000, -5000, 80)}) {
    std::vector<Eigen::Vector3f> points = RandomPoints(300, 1, center, 8);
    points.insert(points.end(), points.begin(), points.begin() + 300);
    for (const float bucket_m : {0.04f, 0.08f, 0.5f}) {
      const NeighborGrid grid(points, bucket_m);
      for (const Eigen::Vector3f& query : RandomPoints(2000, 1.3f, center, 9))
        for (const float radius_m : {0.0f, 0.08f, 0.2f}) {
          const NearestPoint found = grid.FindNearest(query, radius_m);
          const NearestPoint expected = PlainNearest(points, query, radius_m);
          ASSERT_EQ(found.index, expected.index);
          ASSERT_EQ(found.sq_distance, expected.sq_distance);
          // With "enough", another point may be found, but only where that is enough.
          const NearestPoint enough = grid.FindNearest(query, radius_m, 0.05);
          if (!(std::sqrt(static_cast<double>(expected.sq_distance)) < 0.05)) {
            ASSERT_EQ(enough.index, expected.index);
          } else {
            ASSERT_LT(std::sqrt(static_cast<double>(enough.sq_distance)), 0.05);
          }
        }
      for (std::size_t i = 0; i < 300; ++i)
        ASSERT_EQ(grid.FindNearest(points[i], 0.08f).index, static_cast<int>(i));
    }
  }
  EXPECT_EQ(NeighborGrid({}, 0.5f).FindNearest({1, 2, 3}, 10).index, -1);
}

TEST(NeighborGrid, ReportsSquaredDistances) {
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {3, 4, 0}};
  const NeighborGrid grid(points, 1);
  float sq_distance = -1;
  grid.ForEachWithin(points[0], 5, [&](int index, float sq) {
    if (index == 1) sq_distance = sq;
  });
  EXPECT_FLOAT_EQ(sq_distance, 25);
}

TEST(NeighborGrid, VisitsInAnOrderThatDependsOnlyOnThePoints) {
  const std::vector<Eigen::Vector3f> points = RandomPoints(300, 1, {0, 0, 0}, 7);
  const NeighborGrid first(points, 0.25f), second(points, 0.25f);
  std::vector<int> order_first, order_second;
  first.ForEachWithin(points[9], 0.5f, [&](int i, float) { order_first.push_back(i); });
  second.ForEachWithin(points[9], 0.5f, [&](int i, float) { order_second.push_back(i); });
  EXPECT_EQ(order_first, order_second);
}

TEST(NeighborGrid, HoldsNothingOnePointOrManyOnOneSpot) {
  EXPECT_THAT(Found(NeighborGrid({}, 0.5f), {1, 2, 3}, 10), testing::IsEmpty());
  const std::vector<Eigen::Vector3f> one = {{1, 2, 3}};
  EXPECT_THAT(Found(NeighborGrid(one, 0.5f), {1, 2, 3}, 0), testing::ElementsAre(0));
  const std::vector<Eigen::Vector3f> many(7, {1, 2, 3});
  EXPECT_EQ(Found(NeighborGrid(many, 0.5f), {1, 2, 3}, 0.1f).size(), 7u);
}

TEST(NeighborGrid, RefusesWhatItCannotSort) {
  const std::vector<Eigen::Vector3f> good = {{0, 0, 0}};
  EXPECT_THROW(NeighborGrid(good, 0), std::invalid_argument);
  EXPECT_THROW(NeighborGrid(good, -1), std::invalid_argument);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(NeighborGrid(good, nan), std::invalid_argument);
  for (const float bad : {nan, std::numeric_limits<float>::infinity(), 2e9f}) {
    const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {0, bad, 0}};
    EXPECT_THROW(NeighborGrid(points, 0.5f), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fallen
