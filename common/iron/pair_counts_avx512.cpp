// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_counts.hpp"

#if defined(__x86_64__)
#include <immintrin.h>

#include <limits>

#include "fallen/simd/simd_level.hpp"

// Sixteen bases at a time, each in a lane with histograms of its own: nothing is scattered, and no
// two pairs wait for one counter. A lane's eight columns are counters of four bits in one word, so
// that a pair is counted by adding 1 << (4 column); before they can overflow they are emptied into
// bytes, and those into the counts. Rows are nested, as masks are: pairs at all distances, at those
// from row 1 on, and from row 2 on; their differences are the rows.
namespace fallen {
namespace {

constexpr int kRows = ColumnTables::kMaxRows;
constexpr int kNibbleLimit = 15;
constexpr int kByteLimit = 17;  // times a nibble's limit is 255

// Counters of both histograms: [row][histogram].
struct Counters {
  __m512i nibbles[kRows][2];
  __m512i bytes[kRows][2][2];  // of the even and of the odd columns
};

FALLEN_TARGET_AVX512 inline void EmptyNibbles(Counters& counters) {
  const __m512i low = _mm512_set1_epi8(0x0f);
  for (int row = 0; row < kRows; ++row)
    for (int h = 0; h < 2; ++h) {
      __m512i& nibbles = counters.nibbles[row][h];
      __m512i* const bytes = counters.bytes[row][h];
      bytes[0] = _mm512_add_epi8(bytes[0], _mm512_and_si512(nibbles, low));
      bytes[1] = _mm512_add_epi8(bytes[1], _mm512_and_si512(_mm512_srli_epi32(nibbles, 4), low));
      nibbles = _mm512_setzero_si512();
    }
}

FALLEN_TARGET_AVX512 inline void EmptyBytes(Counters& counters, const PairBinning& binning,
                                            std::uint32_t* counts) {
  const __m512i low = _mm512_set1_epi32(0xff);
  for (int row = 0; row < binning.rows; ++row)
    for (int h = 0; h < 2; ++h)
      for (int column = 0; column < binning.columns; ++column) {
        // Nested rows: what is counted from the next row on is not this row's.
        const __m512i shift = _mm512_set1_epi32(8 * (column / 2));
        const auto count_from = [&](int r) __attribute__((target("avx512f"))) {
          return _mm512_and_si512(_mm512_srlv_epi32(counters.bytes[r][h][column % 2], shift), low);
        };
        __m512i count = count_from(row);
        if (row + 1 < kRows) count = _mm512_sub_epi32(count, count_from(row + 1));
        std::uint32_t* const to = counts + PairCountIndex(row, h, column, binning.columns);
        _mm512_storeu_si512(to, _mm512_add_epi32(_mm512_loadu_si512(to), count));
      }
  for (auto& row : counters.bytes)
    for (auto& histogram : row)
      for (__m512i& bytes : histogram) bytes = _mm512_setzero_si512();
}

// See ColumnTables.
struct Tables {
  __m512 signed_edge;
  __m512i increment_below, increment_from;
};

FALLEN_TARGET_AVX512 inline __m512i IncrementOf(__m512 q, const Tables& tables) {
  const __m512i index = _mm512_cvt_roundps_epi32(q, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
  const __mmask16 below =
      _mm512_cmp_ps_mask(q, _mm512_permutexvar_ps(index, tables.signed_edge), _CMP_LT_OQ);
  const __m512i from = _mm512_permutexvar_epi32(index, tables.increment_from);
  return _mm512_mask_permutexvar_epi32(from, below, index, tables.increment_below);
}

}  // namespace

FALLEN_TARGET_AVX512 void CountPairsAvx512(const BaseLanes& bases, const PairCell* cells,
                                           const std::int32_t* near, int near_count,
                                           const PairBinning& binning, const ColumnTables& columns,
                                           std::uint32_t* counts) {
  const __m512 x = _mm512_load_ps(bases.x.data());
  const __m512 y = _mm512_load_ps(bases.y.data());
  const __m512 z = _mm512_load_ps(bases.z.data());
  const __m512 nx = _mm512_load_ps(bases.normal_x.data());
  const __m512 ny = _mm512_load_ps(bases.normal_y.data());
  const __m512 nz = _mm512_load_ps(bases.normal_z.data());
  const __m512 sq_radius = _mm512_set1_ps(binning.sq_radius);
  const __m512 least = _mm512_set1_ps(kLeastSquare);
  const float none = std::numeric_limits<float>::infinity();
  const __m512 row1 = _mm512_set1_ps(binning.rows > 1 ? binning.row_from[0] : none);
  const __m512 row2 = _mm512_set1_ps(binning.rows > 2 ? binning.row_from[1] : none);
  const Tables tables = {_mm512_loadu_ps(columns.signed_edge.data()),
                         _mm512_loadu_si512(columns.increment_below.data()),
                         _mm512_loadu_si512(columns.increment_from.data())};
  Counters counters = {};
  int until_bytes_full = kByteLimit;
  const std::int32_t* at = near;
  const std::int32_t* const end = near + near_count;
  // Two loops, so that the inner one does not drag the bytes along.
  while (at != end) {
    for (int until_full = kNibbleLimit; until_full > 0 && at != end; ++at, --until_full) {
      const PairCell* const cell = cells + *at;
      const __m512 dx = _mm512_sub_ps(x, _mm512_set1_ps(cell->x));
      const __m512 dy = _mm512_sub_ps(y, _mm512_set1_ps(cell->y));
      const __m512 dz = _mm512_sub_ps(z, _mm512_set1_ps(cell->z));
      const __m512 sq_distance = _mm512_add_ps(
          _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy)), _mm512_mul_ps(dz, dz));
      const __mmask16 inside = _mm512_cmp_ps_mask(sq_distance, sq_radius, _CMP_LE_OQ);
      const __m512 between =
          _mm512_add_ps(_mm512_add_ps(_mm512_mul_ps(nx, _mm512_set1_ps(cell->normal_x)),
                                      _mm512_mul_ps(ny, _mm512_set1_ps(cell->normal_y))),
                        _mm512_mul_ps(nz, _mm512_set1_ps(cell->normal_z)));
      const __m512 along = _mm512_add_ps(
          _mm512_add_ps(_mm512_mul_ps(nx, dx), _mm512_mul_ps(ny, dy)), _mm512_mul_ps(nz, dz));
      const __m512i increment0 =
          IncrementOf(_mm512_mul_ps(between, _mm512_abs_ps(between)), tables);
      const __m512i increment1 =
          IncrementOf(_mm512_div_ps(_mm512_mul_ps(along, _mm512_abs_ps(along)),
                                    _mm512_max_ps(sq_distance, least)),
                      tables);
      const __mmask16 from1 = _mm512_mask_cmp_ps_mask(inside, sq_distance, row1, _CMP_GE_OQ);
      const __mmask16 from2 = _mm512_mask_cmp_ps_mask(inside, sq_distance, row2, _CMP_GE_OQ);
      const auto add = [&](int row, __mmask16 mask) __attribute__((target("avx512f"))) {
        __m512i* const to = counters.nibbles[row];
        to[0] = _mm512_mask_add_epi32(to[0], mask, to[0], increment0);
        to[1] = _mm512_mask_add_epi32(to[1], mask, to[1], increment1);
      };
      add(0, inside);
      add(1, from1);
      add(2, from2);
    }
    EmptyNibbles(counters);
    if (--until_bytes_full > 0) continue;
    until_bytes_full = kByteLimit;
    EmptyBytes(counters, binning, counts);
  }
  EmptyBytes(counters, binning, counts);
}

}  // namespace fallen
#endif
