// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_counts.hpp"

#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

using Floats = Lanes<kPortableLanes>::Floats;
using Ints = Lanes<kPortableLanes>::Ints;

Floats SignedSquare(const Floats& c) { return c * (c < 0 ? -c : c); }

Ints RowsOf(const Floats& sq_distance, const PairBinning& binning) {
  Ints row = {};
  for (int k = 0; k < binning.rows - 1; ++k) row -= sq_distance >= binning.row_from[k];
  return row;  // true is -1
}

Ints ColumnsOf(const Floats& q, const PairBinning& binning) {
  Ints column = {};
  for (int k = 0; k < binning.columns - 1; ++k)
    column -= (q < binning.column_below[k]) & (q >= binning.column_from[k]);
  return column;
}

void CountPairsPortable(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                        int near_count, const PairBinning& binning, const ColumnTables&,
                        std::uint32_t* counts) {
  for (int lane = 0; lane < kMostLanes; lane += kPortableLanes) {
    Floats x, y, z, nx, ny, nz;
    Load(x, bases.x.data() + lane);
    Load(y, bases.y.data() + lane);
    Load(z, bases.z.data() + lane);
    Load(nx, bases.normal_x.data() + lane);
    Load(ny, bases.normal_y.data() + lane);
    Load(nz, bases.normal_z.data() + lane);
    for (const std::int32_t* at = near; at != near + near_count; ++at) {
      const PairCell& cell = cells[*at];
      const Floats dx = x - cell.x, dy = y - cell.y, dz = z - cell.z;
      const Floats sq_distance = dx * dx + dy * dy + dz * dz;
      const Ints inside = sq_distance <= binning.sq_radius;
      if (!AnyOf(inside)) continue;
      const Floats between = nx * cell.normal_x + ny * cell.normal_y + nz * cell.normal_z;
      const Floats along = nx * dx + ny * dy + nz * dz;
      const Floats least = Floats{} + kLeastSquare;
      const Ints row = RowsOf(sq_distance, binning);
      const Ints column0 = ColumnsOf(SignedSquare(between), binning);
      const Ints column1 =
          ColumnsOf(SignedSquare(along) / (sq_distance > least ? sq_distance : least), binning);
      for (int l = 0; l < kPortableLanes; ++l) {
        if (inside[l] == 0) continue;
        ++counts[PairCountIndex(row[l], 0, column0[l], binning.columns) + lane + l];
        ++counts[PairCountIndex(row[l], 1, column1[l], binning.columns) + lane + l];
      }
    }
  }
}

}  // namespace

void CountPairs(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                int near_count, const PairBinning& binning, const ColumnTables& tables,
                std::uint32_t* counts) {
  const auto variant = tables.valid
                           ? ChooseSimd(CountPairsPortable, CountPairsAvx2, CountPairsAvx512)
                           : CountPairsPortable;
  variant(bases, cells, near, near_count, binning, tables, counts);
}

#if !defined(__x86_64__)
void CountPairsAvx2(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                    int near_count, const PairBinning& binning, const ColumnTables& tables,
                    std::uint32_t* counts) {
  CountPairsPortable(bases, cells, near, near_count, binning, tables, counts);
}
void CountPairsAvx512(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                      int near_count, const PairBinning& binning, const ColumnTables& tables,
                      std::uint32_t* counts) {
  CountPairsPortable(bases, cells, near, near_count, binning, tables, counts);
}
#endif

}  // namespace fallen
