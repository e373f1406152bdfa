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
      store.FindOrAdd(index).log_odds += 1;
      expected[{index.x, index.y, index.z}] += 1;
    }
    store.RemoveIf([](Voxel& voxel) { return voxel.log_odds == 1; });
    std::erase_if(expected, [](const auto& entry) { return entry.second == 1; });
    ASSERT_EQ(store.voxels().size(), expected.size());
    for (const auto& [index, count] : expected) {
      const auto [x, y, z] = index;
      ASSERT_EQ(store.FindOrAdd({x, y, z}).log_odds, count);
    }
    ASSERT_EQ(store.voxels().size(), expected.size()) << "all were found, none added";
  }
}

TEST(VoxelStore, KeepsTheOrderOfFirstMeeting) {
  VoxelStore store;
  for (const int x : {5, -3, 900, 7}) store.FindOrAdd({x, 0, 0});
  store.FindOrAdd({-3, 0, 0});
  store.RemoveIf([](const Voxel& voxel) { return voxel.index.x == 900; });
  store.FindOrAdd({1, 0, 0});
  std::vector<int> order;
  for (const Voxel& voxel : store.voxels()) order.push_back(voxel.index.x);
  EXPECT_THAT(order, testing::ElementsAre(5, -3, 7, 1));
}

TEST(VoxelStore, TellsFarVoxelsApart) {
  VoxelStore store;
  constexpr int kFar = std::numeric_limits<int>::max();
  store.FindOrAdd({kFar, -kFar, 0}).log_odds = 1;
  store.FindOrAdd({-kFar, kFar, 0}).log_odds = 2;
  EXPECT_EQ(store.FindOrAdd({kFar, -kFar, 0}).log_odds, 1);
  EXPECT_EQ(store.voxels().size(), 2u);
  store.Clear();
  EXPECT_TRUE(store.voxels().empty());
  EXPECT_EQ(store.FindOrAdd({kFar, -kFar, 0}).log_odds, 0);
}

}  // namespace
}  // namespace fallen
