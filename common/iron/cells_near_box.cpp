// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/cells_near_box.hpp"

#include <algorithm>

#include "fallen/simd/lanes.hpp"
#include "fallen/simd/simd_level.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace fallen {
namespace {

// Square of the distance along one axis from the points to the box.
template <class Floats>
[[gnu::always_inline]] inline void SquareGap(const float* coordinates, float low, float high,
                                             Floats& square) {
  Floats p;
  Load(p, coordinates);
  const Floats zero = {}, below = low - p, above = p - high;
  Floats gap = below > above ? below : above;
  gap = gap > zero ? gap : zero;
  square = gap * gap;
}

template <int kLanes>
[[gnu::always_inline]] inline int FindInRuns(const PointColumns& points, const CellRun* runs,
                                             int run_count, const BoxSurroundings& box,
                                             std::int32_t* positions) {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;
  int found = 0;
  for (const CellRun* run = runs; run != runs + run_count; ++run)
    for (std::int32_t k = run->begin; k < run->end; k += kLanes) {
      Floats x, y, z;
      SquareGap(points.x + k, box.low[0], box.high[0], x);
      SquareGap(points.y + k, box.low[1], box.high[1], y);
      SquareGap(points.z + k, box.low[2], box.high[2], z);
      std::int32_t is_near[kLanes];  // true is -1
      Store(Ints(x + y + z <= box.sq_radius), is_near);
      const int lanes = std::min(kLanes, run->end - k);
      for (int lane = 0; lane < lanes; ++lane) {
        positions[found] = k + lane;
        found -= is_near[lane];
      }
    }
  return found;
}

int FindPortable(const PointColumns& points, const CellRun* runs, int run_count,
                 const BoxSurroundings& box, std::int32_t* positions) {
  return FindInRuns<kPortableLanes>(points, runs, run_count, box, positions);
}

FALLEN_TARGET_AVX2 int FindAvx2(const PointColumns& points, const CellRun* runs, int run_count,
                                const BoxSurroundings& box, std::int32_t* positions) {
  return FindInRuns<kAvx2Lanes>(points, runs, run_count, box, positions);
}

#if defined(__x86_64__)
FALLEN_TARGET_AVX512 inline __m512 SquareGapAvx512(const float* coordinates, __m512 low,
                                                   __m512 high) {
  const __m512 p = _mm512_loadu_ps(coordinates);
  const __m512 gap = _mm512_max_ps(_mm512_max_ps(_mm512_sub_ps(low, p), _mm512_sub_ps(p, high)),
                                   _mm512_setzero_ps());
  return _mm512_mul_ps(gap, gap);
}

FALLEN_TARGET_AVX512 int FindAvx512(const PointColumns& points, const CellRun* runs, int run_count,
                                    const BoxSurroundings& box, std::int32_t* positions) {
  const __m512 low_x = _mm512_set1_ps(box.low[0]), high_x = _mm512_set1_ps(box.high[0]);
  const __m512 low_y = _mm512_set1_ps(box.low[1]), high_y = _mm512_set1_ps(box.high[1]);
  const __m512 low_z = _mm512_set1_ps(box.low[2]), high_z = _mm512_set1_ps(box.high[2]);
  const __m512 sq_radius = _mm512_set1_ps(box.sq_radius);
  const __m512i steps = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  int found = 0;
  for (const CellRun* run = runs; run != runs + run_count; ++run)
    for (std::int32_t k = run->begin; k < run->end; k += kMostLanes) {
      const __m512 sq_distance =
          _mm512_add_ps(_mm512_add_ps(SquareGapAvx512(points.x + k, low_x, high_x),
                                      SquareGapAvx512(points.y + k, low_y, high_y)),
                        SquareGapAvx512(points.z + k, low_z, high_z));
      const int left = std::min(kMostLanes, run->end - k);
      const __mmask16 is_near = _mm512_mask_cmp_ps_mask(static_cast<__mmask16>((1u << left) - 1),
                                                        sq_distance, sq_radius, _CMP_LE_OQ);
      const __m512i at = _mm512_add_epi32(_mm512_set1_epi32(k), steps);
      _mm512_storeu_si512(positions + found, _mm512_maskz_compress_epi32(is_near, at));
      found += __builtin_popcount(is_near);
    }
  return found;
}
#else
constexpr auto FindAvx512 = FindAvx2;
#endif

}  // namespace

int FindNearBox(const PointColumns& points, const CellRun* runs, int run_count,
                const BoxSurroundings& box, std::int32_t* positions) {
  return ChooseSimd(FindPortable, FindAvx2, FindAvx512)(points, runs, run_count, box, positions);
}

}  // namespace fallen
