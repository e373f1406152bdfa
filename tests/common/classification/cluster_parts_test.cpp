// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fallen/classification/cluster_classification.hpp"

namespace fallen {
namespace {

constexpr float kCell = 0.05F;

// Adds a level sheet of cells, `length` x `width` cells from `corner`, to the only cluster.
void AddSheet(SegmentedMap& map, const Eigen::Vector2f& corner, int length, int width,
              float score) {
  CellCluster& cluster = map.clusters[0];
  for (int i = 0; i < length; ++i)
    for (int k = 0; k < width; ++k) {
      cluster.cells.push_back(static_cast<std::int32_t>(map.cells.size()));
      ScoredCell& scored = map.cells.emplace_back();
      scored.mean = {corner.x() + kCell * static_cast<float>(i),
                     corner.y() + kCell * static_cast<float>(k), 0.15F};
      scored.score = score;
      scored.cluster = 0;
    }
  cluster.descriptors.resize(static_cast<Eigen::Index>(cluster.cells.size()), 2);
  for (Eigen::Index row = 0; row < cluster.descriptors.rows(); ++row)
    cluster.descriptors.row(row).setConstant(static_cast<float>(row));
}

SegmentedMap Empty() {
  SegmentedMap map;
  map.clusters.resize(1);
  return map;
}

std::vector<CellCluster> PartsOf(const SegmentedMap& map) {
  ClusterPartFinder finder;
  finder.Find(map, map.clusters[0], FitUprightBox(map, map.clusters[0]));
  std::vector<CellCluster> parts(finder.count());
  for (std::size_t i = 0; i < parts.size(); ++i)
    TakeMembers(map.clusters[0], finder.part(i), parts[i]);
  return parts;
}

TEST(ClusterParts, CutThePersonFromWhatScoresLess) {
  SegmentedMap map = Empty();
  AddSheet(map, {0, 0}, 30, 8, 0.03F);      // a person
  AddSheet(map, {0, 0.4F}, 16, 8, 0.006F);  // a dog beside
  const auto parts = PartsOf(map);
  ASSERT_EQ(parts.size(), 2U);  // from both scores the same
  for (const CellCluster& part : parts) {
    EXPECT_EQ(part.cells.size(), 240U);
    for (std::size_t k = 0; k < part.cells.size(); ++k) {
      EXPECT_EQ(map.cells[part.cells[k]].score, 0.03F);
      EXPECT_EQ(part.descriptors(static_cast<Eigen::Index>(k), 1),
                static_cast<float>(part.cells[k]));
    }
  }
}

TEST(ClusterParts, HalveAndQuarterWhatIsTooLongForAPerson) {
  SegmentedMap map = Empty();
  AddSheet(map, {0, 0}, 80, 8, 0.03F);
  const auto parts = PartsOf(map);
  std::multiset<std::size_t> sizes;
  for (const CellCluster& part : parts) sizes.insert(part.cells.size());
  EXPECT_EQ(sizes, (std::multiset<std::size_t>{160, 160, 160, 160, 320, 320}));
  for (const CellCluster& part : parts)
    EXPECT_TRUE(std::is_sorted(part.cells.begin(), part.cells.end()));
}

TEST(ClusterParts, LeaveAPersonWhole) {
  SegmentedMap map = Empty();
  AddSheet(map, {0, 0}, 36, 10, 0.03F);
  EXPECT_TRUE(PartsOf(map).empty());
}

TEST(ClusterParts, DropCrumbs) {
  SegmentedMap map = Empty();
  AddSheet(map, {0, 0}, 8, 6, 0.006F);
  AddSheet(map, {0.4F, 0}, 6, 6, 0.03F);  // 36 cells
  EXPECT_TRUE(PartsOf(map).empty());
  ClusterPartFinder finder;
  finder.Find(map, CellCluster{}, {});
  EXPECT_EQ(finder.count(), 0U);
}

}  // namespace
}  // namespace fallen
