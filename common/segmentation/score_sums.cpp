// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/score_sums.hpp"

#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

template <int kLanes>
[[gnu::always_inline]] inline void SumLanes(const ScoredPoint* points, const std::int32_t* near,
                                            int near_count, float sq_radius, int lane,
                                            ScoreSums& sums) {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;
  Floats x, y, z, sum = {};
  Ints count = {};
  Load(x, sums.x.data() + lane);
  Load(y, sums.y.data() + lane);
  Load(z, sums.z.data() + lane);
  for (const std::int32_t* at = near; at != near + near_count; ++at) {
    const ScoredPoint* const point = points + *at;
    const Floats dx = x - point->x, dy = y - point->y, dz = z - point->z;
    const Ints inside = dx * dx + dy * dy + dz * dz <= sq_radius;
    sum += inside ? Floats{} + point->score : Floats{};
    count += inside & point->count;
  }
  Store(sum, sums.sum.data() + lane);
  Store(count, sums.count.data() + lane);
}

void SumPortable(const ScoredPoint* points, const std::int32_t* near, int near_count,
                 float sq_radius, ScoreSums& sums) {
  for (int lane = 0; lane < kMostLanes; lane += kPortableLanes)
    SumLanes<kPortableLanes>(points, near, near_count, sq_radius, lane, sums);
}

FALLEN_TARGET_AVX2 void SumAvx2(const ScoredPoint* points, const std::int32_t* near, int near_count,
                                float sq_radius, ScoreSums& sums) {
  for (int lane = 0; lane < kMostLanes; lane += kAvx2Lanes)
    SumLanes<kAvx2Lanes>(points, near, near_count, sq_radius, lane, sums);
}
// With masks in registers of their own.
FALLEN_TARGET_AVX512 void SumAvx512(const ScoredPoint* points, const std::int32_t* near,
                                    int near_count, float sq_radius, ScoreSums& sums) {
  for (int lane = 0; lane < kMostLanes; lane += kAvx2Lanes)
    SumLanes<kAvx2Lanes>(points, near, near_count, sq_radius, lane, sums);
}

}  // namespace

void SumScores(const ScoredPoint* points, const std::int32_t* near, int near_count, float sq_radius,
               ScoreSums& sums) {
  ChooseSimd(SumPortable, SumAvx2, SumAvx512)(points, near, near_count, sq_radius, sums);
}

}  // namespace fallen
