// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/voxel_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <tuple>

namespace fallen {
namespace {

VoxelIndex RandomIndex(std::mt19937& generator) {
  std::uniform_int_distribution<int> uniform(-40, 40);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

// Against a std::map, through growth and removal.
TEST(VoxelStore, FindsWhatWasAdded) {
  std::mt19937 generator(1);
  VoxelStore store;
  std::map<std::tuple<int, int, int>, double> expected;
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 20000; ++i) {
      const VoxelIndex index = RandomIndex(generator);
      store.voxels()[store.FindOrAdd(index)].log_odds += 1;
      expected[{index.x, index.y, index.z}] += 1;
    }
    for (std::int32_t i = 0; i < store.size();) {
      if (store.voxels()[i].log_odds == 1)
        store.Remove(i);
      else
        ++i;
    }
    std::erase_if(expected, [](const auto& entry) { return entry.second == 1; });
    ASSERT_EQ(store.voxels().size(), expected.size());
    for (const auto& [index, count] : expected) {
      const auto [x, y, z] = index;
      const std::int32_t position = store.FindOrAdd({x, y, z});
      ASSERT_EQ(store.voxels()[position].log_odds, count);
      ASSERT_TRUE(store.incoming()[position].IsAt({x, y, z}));
    }
    ASSERT_EQ(store.voxels().size(), expected.size()) << "all were found, none added";
  }
}

TEST(VoxelStore, PutsTheLastVoxelWhereOneIsRemoved) {
  VoxelStore store;
  for (const int x : {5, -3, 900, 7}) store.FindOrAdd({x, 0, 0});
  EXPECT_EQ(store.FindOrAdd({-3, 0, 0}), 1);
  store.Remove(1);
  EXPECT_EQ(store.FindOrAdd({7, 0, 0}), 1);
  store.Remove(2);
  EXPECT_EQ(store.FindOrAdd({1, 0, 0}), 2) << "new again";
  std::vector<int> order;
  for (const Voxel& voxel : store.voxels()) order.push_back(voxel.index.x);
  EXPECT_THAT(order, testing::ElementsAre(5, 7, 1));
}

TEST(VoxelStore, LooksAtAGuessFirst) {
  VoxelStore store;
  store.FindOrAdd({5, 0, 0});
  const std::int32_t second = store.FindOrAdd({6, 0, 0});
  for (const std::int32_t guess : {-1, 0, 1, 2, 1000})
    EXPECT_EQ(store.FindOrAdd({6, 0, 0}, guess), second);
  EXPECT_EQ(store.FindOrAdd({7, 0, 0}, 1), 2);
}

TEST(VoxelStore, TellsFarVoxelsApart) {
  VoxelStore store;
  constexpr int kFar = std::numeric_limits<int>::max();
  store.FindOrAdd({kFar, -kFar, 0});
  store.FindOrAdd({-kFar, kFar, 0});
  EXPECT_EQ(store.FindOrAdd({kFar, -kFar, 0}), 0);
  EXPECT_EQ(store.voxels().size(), 2u);
  store.Clear();
  EXPECT_TRUE(store.voxels().empty());
  EXPECT_EQ(store.FindOrAdd({-kFar, kFar, 0}), 0);
}

}  // namespace
}  // namespace fallen
