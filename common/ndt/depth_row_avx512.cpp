// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/depth_row.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>

#include "fallen/simd/simd_level.hpp"

// As depth_row.cpp, sixteen pixels at a time, each summed up as soon as it is placed, with all sums
// of a run in one register.
namespace fallen {
namespace {

constexpr int kLanes = 16;

// A number in all lanes, which the compiler is to keep so.
struct Same {
  __m512 lanes;
  FALLEN_TARGET_AVX512 explicit Same(float value) : lanes(_mm512_set1_ps(value)) {
    asm("" : "+v"(lanes));
  }
};

// RowGeometry and the row's part of the directions.
struct Constants {
  Same depth_unit_m, row_x, row_y, row_z, camera_x, camera_y, camera_z, up_x, up_y, up_z, up_offset,
      clearance_m, clearance_per_sq_m, max_height_m, sq_extent, vertical_weight, cell_size_m,
      inverse_cell_size;
};

struct Placed {
  __mmask16 wanted;
  __m512i voxel_x, voxel_y, voxel_z;    // kNoPoint in lanes that are not wanted
  __m512 offset_x, offset_y, offset_z;  // 0 in those
};

FALLEN_TARGET_AVX512 inline void Split(__mmask16 wanted, __m512 p, const Constants& c,
                                       __m512i& index, __m512& offset) {
  const __m512 scaled = _mm512_mul_ps(p, c.inverse_cell_size.lanes);
  const __m512 floor = _mm512_roundscale_ps(scaled, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
  index = _mm512_mask_cvttps_epi32(_mm512_set1_epi32(kNoPoint), wanted, floor);
  const __m512 center =
      _mm512_mul_ps(_mm512_add_ps(floor, _mm512_set1_ps(0.5F)), c.cell_size_m.lanes);
  offset = _mm512_maskz_sub_ps(wanted, p, center);
}

FALLEN_TARGET_AVX512 inline Placed Place(__m256i depth, int u, const RowDirections& d,
                                         const RowGeometry& g, const Constants& c) {
  Placed placed;
  const __m512i units = _mm512_cvtepu16_epi32(depth);
  __mmask16 wanted = _mm512_cmpge_epi32_mask(units, _mm512_set1_epi32(g.min_depth));
  wanted = _mm512_mask_cmple_epi32_mask(wanted, units, _mm512_set1_epi32(g.max_depth));
  wanted = _mm512_mask_test_epi32_mask(wanted, units, units);
  placed.wanted = wanted;
  if (wanted == 0) return placed;
  const __m512 z_m = _mm512_mul_ps(_mm512_cvtepi32_ps(units), c.depth_unit_m.lanes);
  const auto ray = [&](const float* column, __m512 row) __attribute__((target("avx512f"))) {
    return _mm512_mul_ps(_mm512_add_ps(_mm512_loadu_ps(column + u), row), z_m);
  };
  const __m512 ray_x = ray(d.x, c.row_x.lanes), ray_y = ray(d.y, c.row_y.lanes),
               ray_z = ray(d.z, c.row_z.lanes);
  const __m512 sq_distance =
      _mm512_add_ps(_mm512_add_ps(_mm512_mul_ps(ray_x, ray_x), _mm512_mul_ps(ray_y, ray_y)),
                    _mm512_mul_ps(c.vertical_weight.lanes, _mm512_mul_ps(ray_z, ray_z)));
  const __m512 x = _mm512_add_ps(ray_x, c.camera_x.lanes);
  const __m512 y = _mm512_add_ps(ray_y, c.camera_y.lanes);
  const __m512 z = _mm512_add_ps(ray_z, c.camera_z.lanes);
  const __m512 height = _mm512_add_ps(
      _mm512_add_ps(_mm512_add_ps(_mm512_mul_ps(c.up_x.lanes, x), _mm512_mul_ps(c.up_y.lanes, y)),
                    _mm512_mul_ps(c.up_z.lanes, z)),
      c.up_offset.lanes);
  const __m512 clearance = _mm512_add_ps(
      c.clearance_m.lanes, _mm512_mul_ps(c.clearance_per_sq_m.lanes, _mm512_mul_ps(z_m, z_m)));
  wanted = _mm512_mask_cmp_ps_mask(wanted, sq_distance, c.sq_extent.lanes, _CMP_LE_OQ);
  wanted = _mm512_mask_cmp_ps_mask(wanted, height, clearance, _CMP_GE_OQ);
  wanted = _mm512_mask_cmp_ps_mask(wanted, height, c.max_height_m.lanes, _CMP_LE_OQ);
  placed.wanted = wanted;
  if (wanted == 0) return placed;
  Split(wanted, x, c, placed.voxel_x, placed.offset_x);
  Split(wanted, y, c, placed.voxel_y, placed.offset_y);
  Split(wanted, z, c, placed.voxel_z, placed.offset_z);
  return placed;
}

// Writes x, y, z and 1 of each lane: of lane 4 j + i at 16 i + 4 j.
FALLEN_TARGET_AVX512 inline void StorePoints(const Placed& p, float* to) {
  const __m512 one = _mm512_set1_ps(1);
  const __m512d xy_low = _mm512_castps_pd(_mm512_unpacklo_ps(p.offset_x, p.offset_y));
  const __m512d xy_high = _mm512_castps_pd(_mm512_unpackhi_ps(p.offset_x, p.offset_y));
  const __m512d z1_low = _mm512_castps_pd(_mm512_unpacklo_ps(p.offset_z, one));
  const __m512d z1_high = _mm512_castps_pd(_mm512_unpackhi_ps(p.offset_z, one));
  _mm512_store_ps(to, _mm512_castpd_ps(_mm512_unpacklo_pd(xy_low, z1_low)));
  _mm512_store_ps(to + 16, _mm512_castpd_ps(_mm512_unpackhi_pd(xy_low, z1_low)));
  _mm512_store_ps(to + 32, _mm512_castpd_ps(_mm512_unpacklo_pd(xy_high, z1_high)));
  _mm512_store_ps(to + 48, _mm512_castpd_ps(_mm512_unpackhi_pd(xy_high, z1_high)));
}

// The lanes of `now`, each moved up by one, and the last of `before` in the first.
FALLEN_TARGET_AVX512 inline __m512i Before(__m512i now, __m512i before) {
  return _mm512_alignr_epi32(now, before, 15);
}

// Of each lane, how many lanes of the mask there are up to it.
FALLEN_TARGET_AVX512 inline __m512i CountUpTo(__mmask16 mask) {
  const __m512i zero = _mm512_setzero_si512();
  __m512i count = _mm512_maskz_set1_epi32(mask, 1);
  count = _mm512_add_epi32(count, _mm512_alignr_epi32(count, zero, 15));
  count = _mm512_add_epi32(count, _mm512_alignr_epi32(count, zero, 14));
  count = _mm512_add_epi32(count, _mm512_alignr_epi32(count, zero, 12));
  return _mm512_add_epi32(count, _mm512_alignr_epi32(count, zero, 8));
}

}  // namespace

FALLEN_TARGET_AVX512 int SumRowRunsAvx512(const std::uint16_t* depth, int count,
                                          const RowDirections& directions,
                                          const RowGeometry& geometry, const RowPoints& points,
                                          const RowRuns& runs) {
  const RowGeometry& g = geometry;
  const RowDirections d = directions;
  const Constants constants = {Same(g.depth_unit_m),
                               Same(d.row_x),
                               Same(d.row_y),
                               Same(d.row_z),
                               Same(g.camera_x),
                               Same(g.camera_y),
                               Same(g.camera_z),
                               Same(g.up_x),
                               Same(g.up_y),
                               Same(g.up_z),
                               Same(g.up_offset),
                               Same(g.clearance_m),
                               Same(g.clearance_per_sq_m),
                               Same(g.max_height_m),
                               Same(g.sq_extent),
                               Same(g.vertical_weight),
                               Same(g.cell_size_m),
                               Same(g.inverse_cell_size)};
  const __m512i none = _mm512_set1_epi32(kNoPoint);
  const __m512i steps = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  // A point times 1, x, y and z.
  const __m512i factors = _mm512_setr_epi32(3, 3, 3, 3, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2);
  __m512i last_x = none, last_y = none, last_z = none;
  __m512 sums = _mm512_setzero_ps();
  alignas(64) float offsets[4 * kLanes], goes_on[kLanes];
  alignas(64) std::int32_t run_of[kLanes];
  float* const run_sums = runs.sums->data();
  int found = 0;
  for (int u = 0; u < count; u += kLanes) {
    const auto in_row = static_cast<__mmask16>((1u << std::min(kLanes, count - u)) - 1);
    const Placed placed = Place(_mm256_maskz_loadu_epi16(in_row, depth + u), u, d, g, constants);
    if (placed.wanted == 0) {
      last_x = none;
      continue;
    }
    const __m512i differs = _mm512_or_si512(
        _mm512_or_si512(_mm512_xor_si512(placed.voxel_x, Before(placed.voxel_x, last_x)),
                        _mm512_xor_si512(placed.voxel_y, Before(placed.voxel_y, last_y))),
        _mm512_xor_si512(placed.voxel_z, Before(placed.voxel_z, last_z)));
    const __mmask16 starts = _mm512_mask_test_epi32_mask(placed.wanted, differs, differs);
    last_x = placed.voxel_x;
    last_y = placed.voxel_y;
    last_z = placed.voxel_z;
    _mm512_storeu_si512(points.voxel_x + u, placed.voxel_x);
    _mm512_storeu_si512(points.voxel_y + u, placed.voxel_y);
    _mm512_storeu_si512(points.voxel_z + u, placed.voxel_z);
    _mm512_storeu_si512(
        runs.first + found,
        _mm512_maskz_compress_epi32(starts, _mm512_add_epi32(_mm512_set1_epi32(u), steps)));
    StorePoints(placed, offsets);
    _mm512_store_ps(goes_on, _mm512_mask_blend_ps(starts, _mm512_set1_ps(1), _mm512_setzero_ps()));
    // What is no point is written behind the last run.
    const __m512i run = _mm512_add_epi32(CountUpTo(starts), _mm512_set1_epi32(found));
    _mm512_store_si512(run_of,
                       _mm512_mask_sub_epi32(run, placed.wanted, run, _mm512_set1_epi32(1)));
    found += __builtin_popcount(starts);
    // So that all this is loaded below, not shuffled out of registers.
    asm volatile("" : : "r"(offsets), "r"(goes_on), "r"(run_of) : "memory");
#pragma GCC unroll 16
    for (int lane = 0; lane < kLanes; ++lane) {
      const __m512 point =
          _mm512_broadcast_f32x4(_mm_load_ps(offsets + 16 * (lane % 4) + 4 * (lane / 4)));
      const __m512 products = _mm512_mul_ps(point, _mm512_permutevar_ps(point, factors));
      // Times one or zero is exact: nothing is rounded but the sum.
      sums = _mm512_fmadd_ps(sums, _mm512_set1_ps(goes_on[lane]), products);
      _mm512_store_ps(run_sums + 16 * static_cast<std::ptrdiff_t>(run_of[lane]), sums);
    }
  }
  return found;
}

}  // namespace fallen
#endif
