// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/point_cloud_steps.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

namespace fallen {
namespace {

using Points = std::vector<Eigen::Vector3f>;

// Points on the surface of a box, on a grid of 2 cm.
void AddBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, Points& points) {
  constexpr float kStep = 0.02F;
  const Eigen::Vector3i steps = ((high - low) / kStep).array().round().cast<int>();
  for (int x = 0; x <= steps.x(); ++x)
    for (int y = 0; y <= steps.y(); ++y)
      for (int z = 0; z <= steps.z(); ++z)
        if (x % steps.x() == 0 || y % steps.y() == 0 || z % steps.z() == 0)
          points.push_back(low + kStep * Eigen::Vector3i(x, y, z).cast<float>());
}

Points RandomPoints(int count, float extent_m) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-extent_m, extent_m);
  Points points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

// The definition: everything that steps of at most `tolerance_m` reach, O(n^2).
std::vector<std::vector<std::int32_t>> ClustersByBruteForce(const Points& points, float tolerance_m,
                                                            int min_points) {
  std::vector<std::int32_t> root(points.size());
  std::iota(root.begin(), root.end(), 0);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < points.size(); ++j)
        if ((points[i] - points[j]).norm() <= tolerance_m && root[j] < root[i]) {
          root[i] = root[j];
          has_changed = true;
        }
  }
  std::map<std::int32_t, std::vector<std::int32_t>> members;
  for (std::size_t i = 0; i < points.size(); ++i)
    members[root[i]].push_back(static_cast<std::int32_t>(i));
  std::vector<std::vector<std::int32_t>> clusters;
  for (auto& [first, indices] : members)
    if (static_cast<int>(indices.size()) >= min_points) clusters.push_back(indices);
  std::sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return a.size() != b.size() ? a.size() > b.size() : a[0] < b[0];
  });
  return clusters;
}

TEST(EuclideanClusters, ABoxIsAClusterAndAGapPartsThem) {
  Points points;
  AddBox({1, 0, 0}, {1.4F, 0.4F, 0.2F}, points);
  const std::size_t first = points.size();
  AddBox({1.48F, 0, 0}, {1.6F, 0.2F, 0.2F}, points);
  const std::size_t second = points.size() - first;
  AddBox({3, 0, 0}, {3.04F, 0.04F, 0.04F}, points);
  const auto parted = EuclideanClusters(points, 0.06, 30);
  ASSERT_EQ(parted.size(), 2u);
  EXPECT_EQ(parted[0].size(), first);
  EXPECT_EQ(parted[1].size(), second);
  // A gap of 8 cm: a step of 9 cm joins the first two; the third has 26 points, too few.
  const auto joined = EuclideanClusters(points, 0.09, 30);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].size(), first + second);
}

TEST(EuclideanClusters, AgreeWithBruteForce) {
  // About two neighbours within the tolerance: clusters of all sizes.
  const Points points = RandomPoints(400, 0.5F);
  const auto clusters = EuclideanClusters(points, 0.1, 2);
  EXPECT_GT(clusters.size(), 5u);
  EXPECT_EQ(clusters, ClustersByBruteForce(points, 0.1F, 2));
}

TEST(EuclideanClusters, NothingComesOfNothing) {
  EXPECT_TRUE(EuclideanClusters({}, 0.1, 1).empty());
  EXPECT_TRUE(EuclideanClusters({{1, 2, 3}}, 0.1, 2).empty());
  EXPECT_EQ(EuclideanClusters({{1, 2, 3}}, 0.1, 1).size(), 1u);
}

TEST(ThinPoints, AreTheMeansOfTheVoxels) {
  constexpr float kLeaf = 0.25F;
  const Points points = RandomPoints(2000, 1);
  std::map<std::tuple<int, int, int>, std::pair<Eigen::Vector3f, int>> voxels;
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3i index = (p / kLeaf).array().floor().cast<int>();
    auto [place, is_new] =
        voxels.try_emplace({index.x(), index.y(), index.z()}, Eigen::Vector3f::Zero(), 0);
    place->second.first += p;
    ++place->second.second;
  }
  const Points thinned = ThinPoints(points, kLeaf);
  ASSERT_EQ(thinned.size(), voxels.size());
  for (const Eigen::Vector3f& p : thinned) {
    const Eigen::Vector3i index = (p / kLeaf).array().floor().cast<int>();
    const auto& [sum, count] = voxels.at({index.x(), index.y(), index.z()});
    EXPECT_LT((p - sum / static_cast<float>(count)).norm(), 1e-5F);  // rounding of float sums
  }
  EXPECT_TRUE(ThinPoints({}, kLeaf).empty());
}

TEST(EstimateNormals, ArePerpendicularToAPlaneAndPointToTheCamera) {
  const Eigen::Vector3f normal = Eigen::Vector3f(1, -2, 3).normalized();
  const Eigen::Vector3f u = normal.unitOrthogonal();
  const Eigen::Vector3f v = normal.cross(u);
  Points plane;
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j)
      plane.push_back(Eigen::Vector3f(4, 5, 1) + 0.03F * (i * u + j * v));
  for (const float side : {1.0F, -1.0F}) {
    const Points normals =
        EstimateNormals(plane, Eigen::Vector3f(4, 5, 1) + side * 2 * normal, 0.09);
    ASSERT_EQ(normals.size(), plane.size());
    // Sums of squares of floats 6 m from the origin lose up to about 1e-3.
    for (const Eigen::Vector3f& n : normals) EXPECT_GT(n.dot(side * normal), 1 - 1e-3F);
  }
}

TEST(EstimateNormals, IsZeroWhereTooFewPointsAreKnown) {
  const Points normals = EstimateNormals({{0, 0, 0}, {0.05F, 0, 0}, {5, 5, 5}}, {0, 0, 9}, 0.1);
  for (const Eigen::Vector3f& n : normals) EXPECT_TRUE(n.isZero());
}

}  // namespace
}  // namespace fallen
