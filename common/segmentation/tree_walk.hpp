// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/simd/lanes.hpp"

namespace fallen {

/// A decision tree of depth 4 for rows that walk side by side.
///
/// Filled up to a complete tree, so that all rows take four steps and none branches: the children
/// of node n are 2 n and 2 n + 1, the root is 1, and leaf k is reached as node 16 + k. A leaf that
/// lies higher is reached through nodes that always send left. The whole fits in registers.
struct alignas(64) WalkTree {
  static constexpr int kDepth = 4;

  std::array<float, 16> threshold;       ///< by node; a row goes right if its value is greater
  std::array<std::int32_t, 16> feature;  ///< by node: feature * kMostLanes, place in the block
  std::array<std::int32_t, 16> vote;     ///< by leaf
};

/// A decision tree of depth 5: a root with a tree to each side. Every row walks both and keeps the
/// vote of its own side, which costs less than deeper trees that do not fit in registers.
struct WalkFork {
  WalkTree left, right;
  float threshold;       ///< of the root, as WalkTree's
  std::int32_t feature;  ///< of the root, as WalkTree's
};

/// Adds the trees' votes for kMostLanes rows.
///
/// @param block  Value of feature f and row l at f * kMostLanes + l, aligned to 64 bytes; finite.
/// @param sums   One a row.
/// Votes are whole numbers, so that sums are exact and the same at every SimdLevel.
void AddVotes(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums);
/// Likewise of forks.
void AddVotes(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums);

/// The variants for wide registers.
void AddVotesAvx2(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums);
void AddVotesAvx512(const WalkTree* trees, int tree_count, const float* block, std::int32_t* sums);
void AddVotesAvx2(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums);
void AddVotesAvx512(const WalkFork* forks, int fork_count, const float* block, std::int32_t* sums);

}  // namespace fallen
