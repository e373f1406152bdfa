// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_walk.hpp"

#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

// Rows in turn: a walk is a chain of dependent loads, and eight of them hide each other's latency.
void AddVotesPortable(const WalkTree* trees, int tree_count, const float* block,
                      std::int32_t* sums) {
  constexpr int kSideBySide = 8;
  for (int begin = 0; begin < kMostLanes; begin += kSideBySide)
    for (const WalkTree* tree = trees; tree != trees + tree_count; ++tree) {
      std::array<std::uint32_t, kSideBySide> at;
      at.fill(1);
      for (int step = 0; step < WalkTree::kDepth; ++step)
#pragma GCC unroll 8
        for (int lane = 0; lane < kSideBySide; ++lane) {
          const float value = block[tree->feature[at[lane]] + begin + lane];
          at[lane] = 2 * at[lane] + (value > tree->threshold[at[lane]] ? 1U : 0U);
        }
      for (int lane = 0; lane < kSideBySide; ++lane)
        sums[begin + lane] += tree->vote[at[lane] - 16];
    }
}

}  // namespace

void AddVotes(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  ChooseSimd(AddVotesPortable, AddVotesAvx2, AddVotesAvx512)(trees, tree_count, block, sums);
}

#if !defined(__x86_64__)
void AddVotesAvx2(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(trees, tree_count, block, sums);
}
void AddVotesAvx512(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(trees, tree_count, block, sums);
}
#endif

}  // namespace fallen
