// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/dbscan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace fallen {
namespace {

using Points = std::vector<Eigen::Vector3f>;

// The definition by all pairs: core points, components of their graph by spreading the smallest
// index until nothing changes, border points by their nearest core point.
std::vector<std::int32_t> BruteForce(const Points& points, float epsilon_m, int min_points) {
  const int count = static_cast<int>(points.size());
  const auto sq_distance = [&](int i, int j) { return (points[i] - points[j]).squaredNorm(); };
  const float sq_epsilon = epsilon_m * epsilon_m;
  std::vector<bool> is_core(count);
  for (int i = 0; i < count; ++i) {
    int neighbors = 0;
    for (int j = 0; j < count; ++j) neighbors += sq_distance(i, j) <= sq_epsilon;
    is_core[i] = neighbors >= min_points;
  }
  std::vector<int> first(count);
  for (int i = 0; i < count; ++i) first[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        if (is_core[i] && is_core[j] && first[j] < first[i] && sq_distance(i, j) <= sq_epsilon) {
          first[i] = first[j];
          changed = true;
        }
  }
  std::vector<std::int32_t> labels(count, kNoise);
  std::vector<std::int32_t> number(count, kNoise);
  std::int32_t clusters = 0;
  for (int i = 0; i < count; ++i) {
    if (!is_core[i]) continue;
    if (number[first[i]] == kNoise) number[first[i]] = clusters++;
    labels[i] = number[first[i]];
  }
  for (int i = 0; i < count; ++i) {
    if (is_core[i]) continue;
    int nearest = -1;
    for (int j = 0; j < count; ++j)
      if (is_core[j] && sq_distance(i, j) <= sq_epsilon &&
          (nearest < 0 || sq_distance(i, j) < sq_distance(i, nearest)))
        nearest = j;
    if (nearest >= 0) labels[i] = labels[nearest];
  }
  return labels;
}

Points Blobs(int blobs, int points_each, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> center(0, 3);
  std::normal_distribution<float> spread(0, 0.08F);
  Points points;
  for (int b = 0; b < blobs; ++b) {
    const Eigen::Vector3f middle(center(random), center(random), center(random) / 3);
    for (int i = 0; i < points_each; ++i)
      points.emplace_back(middle + Eigen::Vector3f(spread(random), spread(random), spread(random)));
  }
  for (int i = 0; i < points_each; ++i)
    points.emplace_back(center(random), center(random), center(random) / 3);
  return points;
}

TEST(Dbscan, AgreesWithBruteForceOnRandomClouds) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Points points = Blobs(6, 40, seed);
    for (const int min_points : {1, 2, 6, 12})
      EXPECT_EQ(Dbscan(points, 0.1F, min_points), BruteForce(points, 0.1F, min_points))
          << "seed " << seed << ", min_points " << min_points;
  }
}

TEST(Dbscan, AgreesWithBruteForceOnALatticeFullOfTies) {
  // Steps of 1/16 m and epsilon 1/8 m are exact: many points lie on the radius, many distances tie.
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Points points;
    for (int i = 0; i < 150; ++i)
      points.push_back(Eigen::Vector3f(static_cast<float>(random() % 12),
                                       static_cast<float>(random() % 12),
                                       static_cast<float>(random() % 4)) /
                       16);
    for (const int min_points : {4, 6, 8})
      EXPECT_EQ(Dbscan(points, 0.125F, min_points), BruteForce(points, 0.125F, min_points));
  }
}

TEST(Dbscan, CountsThePointItselfAndTheRadiusItself) {
  const Points pair{{0, 0, 0}, {0.5F, 0, 0}};
  EXPECT_EQ(Dbscan(pair, 0.5F, 2), (std::vector<std::int32_t>{0, 0}));
  EXPECT_EQ(Dbscan(pair, 0.5F, 3), (std::vector<std::int32_t>{kNoise, kNoise}));
  EXPECT_EQ(Dbscan(pair, 0.4F, 1), (std::vector<std::int32_t>{0, 1}));
}

TEST(Dbscan, GivesABorderPointToItsNearestCoreInAnyOrder) {
  // Two rows of core points, and between them a point nearer to the second.
  Points points;
  for (int i = 0; i < 5; ++i) points.emplace_back(-1.0F - 0.1F * static_cast<float>(i), 0, 0);
  for (int i = 0; i < 5; ++i) points.emplace_back(1.0F + 0.1F * static_cast<float>(i), 0, 0);
  points.emplace_back(0.01F, 0, 0);
  const std::vector<std::int32_t> labels = Dbscan(points, 1.02F, 5);
  EXPECT_EQ(labels[10], labels[5]);
  EXPECT_NE(labels[0], labels[5]);
  Points reversed(points.rbegin(), points.rend());
  const std::vector<std::int32_t> reversed_labels = Dbscan(reversed, 1.02F, 5);
  EXPECT_EQ(reversed_labels[0], reversed_labels[5]);
  EXPECT_NE(reversed_labels[0], reversed_labels[10]);
}

TEST(Dbscan, TakesEmptyLoneIdenticalAndFarPoints) {
  EXPECT_TRUE(Dbscan({}, 0.1F, 4).empty());
  EXPECT_EQ(Dbscan(Points{{1, 2, 3}}, 0.1F, 1), std::vector<std::int32_t>{0});
  EXPECT_EQ(Dbscan(Points{{1, 2, 3}}, 0.1F, 2), std::vector<std::int32_t>{kNoise});
  EXPECT_EQ(Dbscan(Points(5, {7, 7, 7}), 0.1F, 5), std::vector<std::int32_t>(5, 0));
  Points far = Blobs(3, 30, 4);
  for (Eigen::Vector3f& point : far) point += Eigen::Vector3f(4000, -4000, 100);
  EXPECT_EQ(Dbscan(far, 0.1F, 5), BruteForce(far, 0.1F, 5));
  EXPECT_EQ(Dbscan(Points{{-1e6F, 0, 0}, {1e6F, 1e6F, 1e6F}}, 0.1F, 1),
            (std::vector<std::int32_t>{0, 1}));
}

TEST(Dbscan, RejectsBrokenArguments) {
  const Points point{{0, 0, 0}};
  EXPECT_THROW(Dbscan(point, 0, 1), std::invalid_argument);
  EXPECT_THROW(Dbscan(point, std::nanf(""), 1), std::invalid_argument);
  EXPECT_THROW(Dbscan(point, std::numeric_limits<float>::infinity(), 1), std::invalid_argument);
  EXPECT_THROW(Dbscan(point, 0.1F, 0), std::invalid_argument);
  EXPECT_THROW(Dbscan(Points{{0, std::nanf(""), 0}}, 0.1F, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
