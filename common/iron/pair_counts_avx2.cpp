// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_counts.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#include <limits>

#include "fallen/simd/simd_level.hpp"

// As pair_counts_avx512.cpp, eight bases at a time and with masks in registers.
namespace fallen {
namespace {

constexpr int kRows = ColumnTables::kMaxRows;
constexpr int kNibbleLimit = 15;
constexpr int kByteLimit = 17;  // times a nibble's limit is 255

struct Counters {
  __m256i nibbles[kRows][2];
  __m256i bytes[kRows][2][2];  // of the even and of the odd columns
};

FALLEN_TARGET_AVX2 inline void EmptyNibbles(Counters& counters) {
  const __m256i low = _mm256_set1_epi8(0x0f);
  for (int row = 0; row < kRows; ++row)
    for (int h = 0; h < 2; ++h) {
      __m256i& nibbles = counters.nibbles[row][h];
      __m256i* const bytes = counters.bytes[row][h];
      bytes[0] = _mm256_add_epi8(bytes[0], _mm256_and_si256(nibbles, low));
      bytes[1] = _mm256_add_epi8(bytes[1], _mm256_and_si256(_mm256_srli_epi32(nibbles, 4), low));
      nibbles = _mm256_setzero_si256();
    }
}

FALLEN_TARGET_AVX2 inline void EmptyBytes(Counters& counters, const PairBinning& binning,
                                          std::uint32_t* counts) {
  const __m256i low = _mm256_set1_epi32(0xff);
  for (int row = 0; row < binning.rows; ++row)
    for (int h = 0; h < 2; ++h)
      for (int column = 0; column < binning.columns; ++column) {
        const __m256i shift = _mm256_set1_epi32(8 * (column / 2));
        const auto count_from = [&](int r) __attribute__((target("avx2"))) {
          return _mm256_and_si256(_mm256_srlv_epi32(counters.bytes[r][h][column % 2], shift), low);
        };
        __m256i count = count_from(row);
        if (row + 1 < kRows) count = _mm256_sub_epi32(count, count_from(row + 1));
        auto* const to =
            reinterpret_cast<__m256i*>(counts + PairCountIndex(row, h, column, binning.columns));
        _mm256_storeu_si256(to, _mm256_add_epi32(_mm256_loadu_si256(to), count));
      }
  for (auto& row : counters.bytes)
    for (auto& histogram : row)
      for (__m256i& bytes : histogram) bytes = _mm256_setzero_si256();
}

struct Tables {
  __m256 edge_positive, edge_negative;
  __m256i shift;  // 4 * least
};

FALLEN_TARGET_AVX2 inline __m256i IncrementOf(__m256 q, const Tables& tables) {
  const __m256 size = _mm256_andnot_ps(_mm256_set1_ps(-0.0F), q);
  const __m256i index = _mm256_cvttps_epi32(size);
  const __m256 edge = _mm256_blendv_ps(_mm256_permutevar8x32_ps(tables.edge_positive, index),
                                       _mm256_permutevar8x32_ps(tables.edge_negative, index), q);
  const __m256i below = _mm256_castps_si256(_mm256_cmp_ps(size, edge, _CMP_LT_OQ));
  const __m256i shift = _mm256_add_epi32(_mm256_permutevar8x32_epi32(tables.shift, index),
                                         _mm256_and_si256(below, _mm256_set1_epi32(4)));
  return _mm256_sllv_epi32(_mm256_set1_epi32(1), shift);
}

FALLEN_TARGET_AVX2 inline void CountLanes(const BaseLanes& bases, int lane, const PairCell* cells,
                                          const std::int32_t* near, int near_count,
                                          const PairBinning& binning, const Tables& tables,
                                          std::uint32_t* counts) {
  const __m256 x = _mm256_load_ps(bases.x.data() + lane);
  const __m256 y = _mm256_load_ps(bases.y.data() + lane);
  const __m256 z = _mm256_load_ps(bases.z.data() + lane);
  const __m256 nx = _mm256_load_ps(bases.normal_x.data() + lane);
  const __m256 ny = _mm256_load_ps(bases.normal_y.data() + lane);
  const __m256 nz = _mm256_load_ps(bases.normal_z.data() + lane);
  const __m256 sq_radius = _mm256_set1_ps(binning.sq_radius);
  const __m256 least = _mm256_set1_ps(kLeastSquare);
  const float none = std::numeric_limits<float>::infinity();
  const __m256 row1 = _mm256_set1_ps(binning.rows > 1 ? binning.row_from[0] : none);
  const __m256 row2 = _mm256_set1_ps(binning.rows > 2 ? binning.row_from[1] : none);
  Counters counters = {};
  int until_bytes_full = kByteLimit;
  const std::int32_t* at = near;
  const std::int32_t* const end = near + near_count;
  // Two loops, so that the inner one does not drag the bytes along.
  while (at != end) {
    for (int until_full = kNibbleLimit; until_full > 0 && at != end; ++at) {
      const PairCell* const cell = cells + *at;
      const __m256 dx = _mm256_sub_ps(x, _mm256_set1_ps(cell->x));
      const __m256 dy = _mm256_sub_ps(y, _mm256_set1_ps(cell->y));
      const __m256 dz = _mm256_sub_ps(z, _mm256_set1_ps(cell->z));
      const __m256 sq_distance = _mm256_add_ps(
          _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy)), _mm256_mul_ps(dz, dz));
      const __m256 inside = _mm256_cmp_ps(sq_distance, sq_radius, _CMP_LE_OQ);
      if (_mm256_movemask_ps(inside) == 0) continue;
      const __m256 between =
          _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(nx, _mm256_set1_ps(cell->normal_x)),
                                      _mm256_mul_ps(ny, _mm256_set1_ps(cell->normal_y))),
                        _mm256_mul_ps(nz, _mm256_set1_ps(cell->normal_z)));
      const __m256 along = _mm256_add_ps(
          _mm256_add_ps(_mm256_mul_ps(nx, dx), _mm256_mul_ps(ny, dy)), _mm256_mul_ps(nz, dz));
      const __m256 sign = _mm256_set1_ps(-0.0F);
      const __m256i increment0 =
          IncrementOf(_mm256_mul_ps(between, _mm256_andnot_ps(sign, between)), tables);
      const __m256i increment1 =
          IncrementOf(_mm256_div_ps(_mm256_mul_ps(along, _mm256_andnot_ps(sign, along)),
                                    _mm256_max_ps(sq_distance, least)),
                      tables);
      const auto add = [&](int row, __m256 mask) __attribute__((target("avx2"))) {
        __m256i* const to = counters.nibbles[row];
        const __m256i wanted = _mm256_castps_si256(mask);
        to[0] = _mm256_add_epi32(to[0], _mm256_and_si256(increment0, wanted));
        to[1] = _mm256_add_epi32(to[1], _mm256_and_si256(increment1, wanted));
      };
      add(0, inside);
      add(1, _mm256_and_ps(inside, _mm256_cmp_ps(sq_distance, row1, _CMP_GE_OQ)));
      add(2, _mm256_and_ps(inside, _mm256_cmp_ps(sq_distance, row2, _CMP_GE_OQ)));
      --until_full;
    }
    EmptyNibbles(counters);
    if (--until_bytes_full > 0) continue;
    until_bytes_full = kByteLimit;
    EmptyBytes(counters, binning, counts);
  }
  EmptyBytes(counters, binning, counts);
}

}  // namespace

FALLEN_TARGET_AVX2 void CountPairsAvx2(const BaseLanes& bases, const PairCell* cells,
                                       const std::int32_t* near, int near_count,
                                       const PairBinning& binning, const ColumnTables& columns,
                                       std::uint32_t* counts) {
  alignas(32) std::int32_t shift[8];
  for (int k = 0; k < 8; ++k) shift[k] = 4 * columns.least[k];
  const Tables tables = {_mm256_loadu_ps(columns.edge_positive.data()),
                         _mm256_loadu_ps(columns.edge_negative.data()),
                         _mm256_load_si256(reinterpret_cast<const __m256i*>(shift))};
  for (int lane = 0; lane < kMostLanes; lane += 8)
    CountLanes(bases, lane, cells, near, near_count, binning, tables, counts + lane);
}

}  // namespace fallen
#endif
