// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/iron/pair_binning.hpp"
#include "fallen/simd/lanes.hpp"

namespace fallen {

/// Cells that are described side by side, coordinate by coordinate: one a lane.
struct alignas(64) BaseLanes {
  using Coordinate = std::array<float, kMostLanes>;
  Coordinate x, y, z;                       ///< mean [m]; kNowhere in lanes that are not used
  Coordinate normal_x, normal_y, normal_z;  ///< of length PairBinning::kNormalScale
};
/// Farther from every cell than any radius, and its square is still finite.
inline constexpr float kNowhere = 1e18F;

/// A cell as neighbour.
struct alignas(32) PairCell {
  float x, y, z;
  float normal_x, normal_y, normal_z;
};

/// Index of a lane's count: histogram 0 of the angles between the normals, 1 of those between the
/// base's normal and the line from mean to mean.
inline int PairCountIndex(int row, int histogram, int column, int columns) {
  return ((row * 2 + histogram) * columns + column) * kMostLanes;
}

/// Adds the pairs of each base with the cells at `near` to the base's lane of `counts`.
///
/// Angles are folded to 90 degrees if the binning is; one on an edge belongs to the bin above it;
/// the line between equal means counts as 90 degrees, so that a base among the cells counts as a
/// neighbour in row 0, column 0 and the column of 90 degrees, folded the last.
/// @param counts  kMostLanes counts for each row, histogram and column, see PairCountIndex.
/// The same counts at every SimdLevel.
void CountPairs(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                int near_count, const PairBinning& binning, const ColumnTables& tables,
                std::uint32_t* counts);

/// The variants for wide registers; they need valid tables.
void CountPairsAvx2(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                    int near_count, const PairBinning& binning, const ColumnTables& tables,
                    std::uint32_t* counts);
void CountPairsAvx512(const BaseLanes& bases, const PairCell* cells, const std::int32_t* near,
                      int near_count, const PairBinning& binning, const ColumnTables& tables,
                      std::uint32_t* counts);

/// In place of the squared distance of equal means, so that nothing is divided by zero.
inline constexpr float kLeastSquare = 1.17549435e-38F;

}  // namespace fallen
