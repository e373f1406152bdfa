// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_walk.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#include "fallen/simd/simd_level.hpp"

// Nothing is gathered: a step loads the values of all features that its level asks for and keeps,
// by masks, what each row's way asks for. At fifteen features a tree that is cheaper than gathers.
namespace fallen {
namespace {

FALLEN_TARGET_AVX512 inline __m512 ValueAt(const WalkTree& tree, int node, const float* block) {
  return _mm512_load_ps(block + tree.feature[node]);
}

// Values of two sibling nodes: the right one's where the way went right.
FALLEN_TARGET_AVX512 inline __m512 ValueBelow(const WalkTree& tree, int left, __mmask16 went_right,
                                              const float* block) {
  return _mm512_mask_load_ps(ValueAt(tree, left, block), went_right,
                             block + tree.feature[left + 1]);
}

FALLEN_TARGET_AVX512 inline __mmask16 GoesRight(__m512 value, __m512i at, __m512 thresholds) {
  return _mm512_cmp_ps_mask(value, _mm512_permutexvar_ps(at, thresholds), _CMP_GT_OQ);
}

FALLEN_TARGET_AVX512 inline __m512i Below(__m512i at, __mmask16 goes_right) {
  const __m512i left = _mm512_add_epi32(at, at);
  return _mm512_mask_add_epi32(left, goes_right, left, _mm512_set1_epi32(1));
}

FALLEN_TARGET_AVX512 inline __m512i VoteOf(const WalkTree& tree, const float* block) {
  const __m512 thresholds = _mm512_load_ps(tree.threshold.data());
  const __mmask16 right0 =
      _mm512_cmp_ps_mask(ValueAt(tree, 1, block), _mm512_set1_ps(tree.threshold[1]), _CMP_GT_OQ);
  __m512i at = _mm512_mask_blend_epi32(right0, _mm512_set1_epi32(2), _mm512_set1_epi32(3));
  const __mmask16 right1 = GoesRight(ValueBelow(tree, 2, right0, block), at, thresholds);
  at = Below(at, right1);
  const __m512 value2 = _mm512_mask_blend_ps(right0, ValueBelow(tree, 4, right1, block),
                                             ValueBelow(tree, 6, right1, block));
  const __mmask16 right2 = GoesRight(value2, at, thresholds);
  at = Below(at, right2);
  const __m512 left_half = _mm512_mask_blend_ps(right1, ValueBelow(tree, 8, right2, block),
                                                ValueBelow(tree, 10, right2, block));
  const __m512 right_half = _mm512_mask_blend_ps(right1, ValueBelow(tree, 12, right2, block),
                                                 ValueBelow(tree, 14, right2, block));
  const __m512 value3 = _mm512_mask_blend_ps(right0, left_half, right_half);
  at = Below(at, GoesRight(value3, at, thresholds));
  return _mm512_permutexvar_epi32(at, _mm512_load_si512(tree.vote.data()));  // at modulo 16
}

FALLEN_TARGET_AVX512 inline __m512i VoteOf(const WalkFork& fork, const float* block) {
  const __mmask16 right = _mm512_cmp_ps_mask(_mm512_load_ps(block + fork.feature),
                                             _mm512_set1_ps(fork.threshold), _CMP_GT_OQ);
  return _mm512_mask_blend_epi32(right, VoteOf(fork.left, block), VoteOf(fork.right, block));
}

template <class Tree>
FALLEN_TARGET_AVX512 void Add(const Tree* trees, int tree_count, const float* block,
                              std::int32_t* sums) {
  __m512i sum = _mm512_loadu_si512(sums);
  for (const Tree* tree = trees; tree != trees + tree_count; ++tree)
    sum = _mm512_add_epi32(sum, VoteOf(*tree, block));
  _mm512_storeu_si512(sums, sum);
}

}  // namespace

FALLEN_TARGET_AVX512 void AddVotesAvx512(const WalkTree* trees, int tree_count, const float* block,
                                         std::int32_t* sums) {
  Add(trees, tree_count, block, sums);
}

FALLEN_TARGET_AVX512 void AddVotesAvx512(const WalkFork* forks, int fork_count, const float* block,
                                         std::int32_t* sums) {
  Add(forks, fork_count, block, sums);
}

}  // namespace fallen
#endif
