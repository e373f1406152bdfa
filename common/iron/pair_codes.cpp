// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_codes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace fallen {
namespace {

// The paper's number of angle bins: known when compiling, the loop over the edges is unrolled and
// the pairs stay in registers. 0 stands for "known when running".
constexpr int kPaperColumns = 8;
constexpr int kMaxColumns = 32;
// In place of the squared distance of equal means, so that nothing is divided by zero.
constexpr float kLeastSquare = std::numeric_limits<float>::min();

// Pairs at a time, in the vector extensions of GCC and Clang: as many as a register holds, and the
// same operations on each number.
constexpr int kPortableLanes = 4;
constexpr int kAvx2Lanes = 8;
static_assert(kPairPadding >= kAvx2Lanes);

template <int kLanes>
struct Vector;
template <>
struct Vector<kPortableLanes> {
  using Floats = float __attribute__((vector_size(16)));
  using Ints = std::int32_t __attribute__((vector_size(16)));
};
template <>
struct Vector<kAvx2Lanes> {
  using Floats = float __attribute__((vector_size(32)));
  using Ints = std::int32_t __attribute__((vector_size(32)));
};

template <class Floats>
[[gnu::always_inline]] inline void Load(Floats& vector, const float* from) {
  std::memcpy(&vector, from, sizeof(vector));
}

template <class Floats>
[[gnu::always_inline]] inline void TakeRoots(Floats& values) {
  for (std::size_t lane = 0; lane < sizeof(values) / sizeof(float); ++lane)
    values[lane] = std::sqrt(values[lane]);
}

// Cosines in whole steps, their sign dropped after rounding down.
template <class Floats, class Ints>
[[gnu::always_inline]] inline void CountSteps(const Floats& cosine, Ints& steps) {
  const Floats above_minus_one = (cosine + 1.0f) * static_cast<float>(kCosineSteps);
  steps = __builtin_convertvector(above_minus_one, Ints) - kCosineSteps;
  steps = steps < 0 ? -steps : steps;
}

template <int kLanes, int kColumns>
[[gnu::always_inline]] inline int CodesOfRuns(const CellArrays& cells, int base,
                                              std::span<const CellRun> runs,
                                              const PairBinning& binning, std::uint32_t* codes) {
  using Floats = typename Vector<kLanes>::Floats;
  using Ints = typename Vector<kLanes>::Ints;
  const int columns = kColumns > 0 ? kColumns : binning.columns;
  const int rows = binning.rows;
  const int beyond = JointBins(binning);
  const float sq_radius = binning.sq_radius, rows_per_sq_m = binning.rows_per_sq_m;
  const float x = cells.x[base], y = cells.y[base], z = cells.z[base];
  const float nx = cells.normal_x[base], ny = cells.normal_y[base], nz = cells.normal_z[base];
  std::array<int, kMaxColumns> above_edges;
  for (int k = 0; k < columns - 1; ++k) above_edges[k] = binning.cosine_edges[k] + 1;
  Ints lane_number;
  for (int lane = 0; lane < kLanes; ++lane) lane_number[lane] = lane;
  std::uint32_t* next = codes;
  for (const CellRun& run : runs) {
    for (int j = run.begin; j < run.end; j += kLanes) {
      Floats dx, dy, dz, other_nx, other_ny, other_nz;
      Load(dx, cells.x + j);
      Load(dy, cells.y + j);
      Load(dz, cells.z + j);
      Load(other_nx, cells.normal_x + j);
      Load(other_ny, cells.normal_y + j);
      Load(other_nz, cells.normal_z + j);
      dx = x - dx;
      dy = y - dy;
      dz = z - dz;
      const Floats sq_distance = dx * dx + dy * dy + dz * dz;
      const Ints inside = (sq_distance <= sq_radius) & (lane_number < run.end - j);
      const Floats between_normals = nx * other_nx + ny * other_ny + nz * other_nz;
      const Floats along = nx * dx + ny * dy + nz * dz;
      const Floats least = Floats{} + kLeastSquare;
      Floats distance = sq_distance > least ? sq_distance : least;
      TakeRoots(distance);
      Ints steps1, steps2;
      CountSteps(between_normals, steps1);
      CountSteps(along / distance, steps2);
      Ints column1 = {}, column2 = {};
      for (int k = 0; k < columns - 1; ++k) {
        column1 -= steps1 < above_edges[k];  // true is -1
        column2 -= steps2 < above_edges[k];
      }
      const Floats within = inside ? sq_distance : Floats{};  // so that no row overflows
      const Ints raw_row = __builtin_convertvector(within * rows_per_sq_m, Ints);
      const Ints last_row = Ints{} + (rows - 1);
      const Ints row = raw_row < last_row ? raw_row : last_row;
      const Ints bin = (row * columns + column1) * columns + column2;
      const Ints code = inside ? bin : Ints{} + beyond;
      // Lanes beyond the run are overwritten by the next.
      std::memcpy(next + (j - run.begin), &code, sizeof(code));
    }
    next += run.end - run.begin;
  }
  return static_cast<int>(next - codes);
}

int CodesPortable(const CellArrays& cells, int base, std::span<const CellRun> runs,
                  const PairBinning& binning, std::uint32_t* codes) {
  if (binning.columns == kPaperColumns)
    return CodesOfRuns<kPortableLanes, kPaperColumns>(cells, base, runs, binning, codes);
  return CodesOfRuns<kPortableLanes, 0>(cells, base, runs, binning, codes);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] int CodesAvx2(const CellArrays& cells, int base,
                                      std::span<const CellRun> runs, const PairBinning& binning,
                                      std::uint32_t* codes) {
  if (binning.columns == kPaperColumns)
    return CodesOfRuns<kAvx2Lanes, kPaperColumns>(cells, base, runs, binning, codes);
  return CodesOfRuns<kAvx2Lanes, 0>(cells, base, runs, binning, codes);
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

int ComputePairCodes(const CellArrays& cells, int base, std::span<const CellRun> runs,
                     const PairBinning& binning, std::uint32_t* codes) {
  static const bool has_avx2 = HasAvx2();
  if (has_avx2) return CodesAvx2(cells, base, runs, binning, codes);
  return CodesPortable(cells, base, runs, binning, codes);
}

void SumLanes(std::uint32_t* counts, int lanes, int stride, int count) {
  for (int lane = 1; lane < lanes; ++lane) {
    const std::uint32_t* __restrict from = counts + static_cast<std::ptrdiff_t>(lane) * stride;
    std::uint32_t* __restrict to = counts;
    for (int k = 0; k < count; ++k) to[k] += from[k];
  }
}

}  // namespace fallen
