// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_codes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace fallen {
namespace {

// The paper's number of angle bins: known when compiling, the loop over the edges is unrolled and
// the pairs go through vector registers. 0 stands for "known when running".
constexpr int kPaperColumns = 8;
constexpr int kMaxColumns = 64;
// In place of the squared distance of equal means, so that nothing is divided by zero.
constexpr float kLeastSquare = std::numeric_limits<float>::min();

// A cosine in whole steps, its sign dropped after rounding down.
[[gnu::always_inline]] inline int CosineSteps(float cosine) {
  const int above_minus_one = static_cast<int>((cosine + 1) * kCosineSteps);
  return std::abs(above_minus_one - kCosineSteps);
}

template <int kColumns>
[[gnu::always_inline]] inline void CodesOfRange(const CellArrays& cells, int base, int begin,
                                                int end, const PairBinning& binning,
                                                std::uint32_t* __restrict codes) {
  const int columns = kColumns > 0 ? kColumns : binning.columns;
  const int rows = binning.rows;
  const int beyond = rows * columns;
  const float sq_radius = binning.sq_radius, rows_per_sq_m = binning.rows_per_sq_m;
  const float x = cells.x[base], y = cells.y[base], z = cells.z[base];
  const float nx = cells.normal_x[base], ny = cells.normal_y[base], nz = cells.normal_z[base];
  int edges[kMaxColumns];
  std::copy_n(binning.cosine_edges, columns - 1, edges);
  for (int j = begin; j < end; ++j) {
    const float dx = x - cells.x[j], dy = y - cells.y[j], dz = z - cells.z[j];
    const float sq_distance = dx * dx + dy * dy + dz * dz;
    const float between_normals =
        nx * cells.normal_x[j] + ny * cells.normal_y[j] + nz * cells.normal_z[j];
    const float along = nx * dx + ny * dy + nz * dz;
    const float to_line = along / std::sqrt(std::max(sq_distance, kLeastSquare));
    const int steps1 = CosineSteps(between_normals);
    const int steps2 = CosineSteps(to_line);
    int column1 = 0, column2 = 0;
    for (int k = 0; k < columns - 1; ++k) {
      column1 += steps1 <= edges[k] ? 1 : 0;
      column2 += steps2 <= edges[k] ? 1 : 0;
    }
    const int row = static_cast<int>(std::min(sq_distance, sq_radius) * rows_per_sq_m);
    const int row_begin = std::min(row, rows - 1) * columns;
    const bool inside = sq_distance <= sq_radius;
    const int bin1 = inside ? row_begin + column1 : beyond;
    const int bin2 = inside ? row_begin + column2 : beyond;
    codes[j - begin] = static_cast<std::uint32_t>(bin1 | bin2 << 16);
  }
}

void CodesPortable(const CellArrays& cells, int base, int begin, int end,
                   const PairBinning& binning, std::uint32_t* codes) {
  if (binning.columns == kPaperColumns)
    return CodesOfRange<kPaperColumns>(cells, base, begin, end, binning, codes);
  CodesOfRange<0>(cells, base, begin, end, binning, codes);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void CodesAvx2(const CellArrays& cells, int base, int begin, int end,
                                       const PairBinning& binning, std::uint32_t* codes) {
  if (binning.columns == kPaperColumns)
    return CodesOfRange<kPaperColumns>(cells, base, begin, end, binning, codes);
  CodesOfRange<0>(cells, base, begin, end, binning, codes);
}

bool HasAvx2() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2");
}
#else
constexpr auto CodesAvx2 = CodesPortable;
constexpr bool HasAvx2() { return false; }
#endif

}  // namespace

void ComputePairCodes(const CellArrays& cells, int base, int begin, int end,
                      const PairBinning& binning, std::uint32_t* codes) {
  static const bool has_avx2 = HasAvx2();
  if (has_avx2) return CodesAvx2(cells, base, begin, end, binning, codes);
  CodesPortable(cells, base, begin, end, binning, codes);
}

}  // namespace fallen
