// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_walk.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#include "fallen/simd/simd_level.hpp"

// As tree_walk_avx512.cpp, eight rows at a time.
namespace fallen {
namespace {

FALLEN_TARGET_AVX2 inline __m256 ValueAt(const WalkTree& tree, int node, const float* block) {
  return _mm256_load_ps(block + tree.feature[node]);
}

FALLEN_TARGET_AVX2 inline __m256 ValueBelow(const WalkTree& tree, int left, __m256 went_right,
                                            const float* block) {
  return _mm256_blendv_ps(ValueAt(tree, left, block), ValueAt(tree, left + 1, block), went_right);
}

// `nodes` are the thresholds of up to eight nodes of one level, `at` the place within the level.
FALLEN_TARGET_AVX2 inline __m256 GoesRight(__m256 value, __m256i at, const float* nodes) {
  const __m256 threshold = _mm256_permutevar8x32_ps(_mm256_loadu_ps(nodes), at);
  return _mm256_cmp_ps(value, threshold, _CMP_GT_OQ);
}

FALLEN_TARGET_AVX2 inline __m256i Below(__m256i at, __m256 goes_right) {
  return _mm256_sub_epi32(_mm256_add_epi32(at, at), _mm256_castps_si256(goes_right));  // true: -1
}

FALLEN_TARGET_AVX2 inline __m256i VoteOf(const WalkTree& tree, const float* block) {
  const float* const thresholds = tree.threshold.data();
  const __m256 right0 =
      _mm256_cmp_ps(ValueAt(tree, 1, block), _mm256_broadcast_ss(thresholds + 1), _CMP_GT_OQ);
  __m256i at = Below(_mm256_setzero_si256(), right0);
  const __m256 right1 = GoesRight(ValueBelow(tree, 2, right0, block), at, thresholds + 2);
  at = Below(at, right1);
  const __m256 value2 = _mm256_blendv_ps(ValueBelow(tree, 4, right1, block),
                                         ValueBelow(tree, 6, right1, block), right0);
  const __m256 right2 = GoesRight(value2, at, thresholds + 4);
  at = Below(at, right2);
  const __m256 left_half = _mm256_blendv_ps(ValueBelow(tree, 8, right2, block),
                                            ValueBelow(tree, 10, right2, block), right1);
  const __m256 right_half = _mm256_blendv_ps(ValueBelow(tree, 12, right2, block),
                                             ValueBelow(tree, 14, right2, block), right1);
  const __m256 right3 =
      GoesRight(_mm256_blendv_ps(left_half, right_half, right0), at, thresholds + 8);
  at = Below(at, right3);  // modulo 8 within the half that the first step chose
  const auto votes_of = [&](const std::int32_t* leaves) __attribute__((target("avx2"))) {
    const __m256i votes = _mm256_load_si256(reinterpret_cast<const __m256i*>(leaves));
    return _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(votes, at));
  };
  return _mm256_castps_si256(
      _mm256_blendv_ps(votes_of(tree.vote.data()), votes_of(tree.vote.data() + 8), right0));
}

FALLEN_TARGET_AVX2 inline __m256i VoteOf(const WalkFork& fork, const float* block) {
  const __m256 right = _mm256_cmp_ps(_mm256_load_ps(block + fork.feature),
                                     _mm256_broadcast_ss(&fork.threshold), _CMP_GT_OQ);
  return _mm256_blendv_epi8(VoteOf(fork.left, block), VoteOf(fork.right, block),
                            _mm256_castps_si256(right));
}

template <class Tree>
FALLEN_TARGET_AVX2 void Add(const Tree* trees, int tree_count, const float* block,
                            std::int32_t* sums) {
  auto* const left = reinterpret_cast<__m256i*>(sums);
  auto* const right = reinterpret_cast<__m256i*>(sums + 8);
  __m256i sum_left = _mm256_loadu_si256(left), sum_right = _mm256_loadu_si256(right);
  for (const Tree* tree = trees; tree != trees + tree_count; ++tree) {
    sum_left = _mm256_add_epi32(sum_left, VoteOf(*tree, block));
    sum_right = _mm256_add_epi32(sum_right, VoteOf(*tree, block + 8));
  }
  _mm256_storeu_si256(left, sum_left);
  _mm256_storeu_si256(right, sum_right);
}

}  // namespace

FALLEN_TARGET_AVX2 void AddVotesAvx2(const WalkTree* trees, int tree_count, const float* block,
                                     std::int32_t* sums) {
  Add(trees, tree_count, block, sums);
}

FALLEN_TARGET_AVX2 void AddVotesAvx2(const WalkFork* forks, int fork_count, const float* block,
                                     std::int32_t* sums) {
  Add(forks, fork_count, block, sums);
}

}  // namespace fallen
#endif
