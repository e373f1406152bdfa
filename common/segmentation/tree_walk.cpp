// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_walk.hpp"

#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

// Rows in turn: a walk is a chain of dependent loads, and eight of them hide each other's latency.
constexpr int kSideBySide = 8;
using Votes = std::array<std::int32_t, kSideBySide>;

inline Votes VotesOf(const WalkTree& tree, const float* rows) {
  std::array<std::uint32_t, kSideBySide> at;
  at.fill(1);
  for (int step = 0; step < WalkTree::kDepth; ++step)
#pragma GCC unroll 8
    for (int lane = 0; lane < kSideBySide; ++lane) {
      const float value = rows[tree.feature[at[lane]] + lane];
      at[lane] = 2 * at[lane] + (value > tree.threshold[at[lane]] ? 1U : 0U);
    }
  Votes votes;
  for (int lane = 0; lane < kSideBySide; ++lane) votes[lane] = tree.vote[at[lane] - 16];
  return votes;
}

inline Votes VotesOf(const WalkFork& fork, const float* rows) {
  const Votes left = VotesOf(fork.left, rows);
  Votes votes = VotesOf(fork.right, rows);
  for (int lane = 0; lane < kSideBySide; ++lane)
    if (!(rows[fork.feature + lane] > fork.threshold)) votes[lane] = left[lane];
  return votes;
}

template <class Tree>
void AddVotesPortable(const Tree* trees, int tree_count, const float* block, std::int32_t* sums) {
  for (int begin = 0; begin < kMostLanes; begin += kSideBySide)
    for (const Tree* tree = trees; tree != trees + tree_count; ++tree) {
      const Votes votes = VotesOf(*tree, block + begin);
      for (int lane = 0; lane < kSideBySide; ++lane) sums[begin + lane] += votes[lane];
    }
}

template <class Tree>
void AddVotesAtLevel(const Tree* trees, int tree_count, const float* block, std::int32_t* sums) {
  using Kernel = void(const Tree*, int, const float*, std::int32_t*);
  ChooseSimd<Kernel>(AddVotesPortable<Tree>, AddVotesAvx2, AddVotesAvx512)(trees, tree_count, block,
                                                                           sums);
}

}  // namespace

void AddVotes(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  AddVotesAtLevel(trees, tree_count, block, sums);
}

void AddVotes(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums) {
  AddVotesAtLevel(forks, fork_count, block, sums);
}

#if !defined(__x86_64__)
void AddVotesAvx2(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(trees, tree_count, block, sums);
}
void AddVotesAvx512(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(trees, tree_count, block, sums);
}
void AddVotesAvx2(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(forks, fork_count, block, sums);
}
void AddVotesAvx512(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums) {
  AddVotesPortable(forks, fork_count, block, sums);
}
#endif

}  // namespace fallen
