// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace fallen {

/// Means and normals of the cells, coordinate by coordinate, in the order of a NeighborGrid. Plain
/// pointers, so that the kernel below may be compiled for wider processors than its callers.
struct CellArrays {
  const float* x;
  const float* y;
  const float* z;
  const float* normal_x;
  const float* normal_y;
  const float* normal_z;
};

/// Steps of the cosine within [0, 1] that are told apart.
///
/// The reference implementation looks the arccos up in a table of 5 000 entries over [-1, 1], at
/// the entry below the cosine. So do we, in whole steps and without the table: a cosine counts as
/// the lower end of its step, and the angle between two normals within a step of a bin edge falls
/// on one side or the other by the normals' signs.
inline constexpr int kCosineSteps = 2500;

/// Pairs are binned so many at a time: the cell arrays need that many more values behind the last
/// cell, whatever they are but finite, and the codes that much room.
inline constexpr int kPairPadding = 8;

/// What decides the histogram bins of a pair.
struct PairBinning {
  float sq_radius;      ///< pairs beyond it are no neighbours [m^2]
  float rows_per_sq_m;  ///< rows / sq_radius
  int rows;
  int columns;
  const int* cosine_edges;  ///< columns - 1 inner edges between the angle bins, falling, in steps
};

/// Bins of both histograms together, and the code of a pair that belongs to none.
inline int JointBins(const PairBinning& binning) {
  return binning.rows * binning.columns * binning.columns;
}

/// Cells at positions [begin, end).
struct CellRun {
  std::int32_t begin;
  std::int32_t end;
};

/// Bins of the pairs (`base`, j) for all j in `runs`, in both histograms at once.
///
/// Row by the squared distance; column 1 by the angle between the normals, column 2 by the angle
/// between the base's normal and the line from mean to mean, both folded to 90 degrees. An angle on
/// an edge belongs to the bin above it; the line between equal means counts as 90 degrees.
/// @param codes  Room for one value a pair and kPairPadding more: (row * columns + column 1) *
/// columns + column 2, or JointBins for
///               pairs beyond the radius.
/// @return  Number of pairs.
/// The same bits on every processor.
int ComputePairCodes(const CellArrays& cells, int base, std::span<const CellRun> runs,
                     const PairBinning& binning, std::uint32_t* codes);

/// Adds up `lanes` arrays of `count` counts that lie `stride` apart, into the first.
void SumLanes(std::uint32_t* counts, int lanes, int stride, int count);

}  // namespace fallen
