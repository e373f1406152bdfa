// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/iron/iron_descriptor.hpp"

namespace fallen {

/// Steps of the cosine within [0, 1] that are told apart.
///
/// The reference implementation looks the arccos up in a table of 5 000 entries over [-1, 1], at
/// the entry below the cosine. So do we, without the table: a cosine counts as the lower end of its
/// step, and an angle within a step of a bin edge falls on one side or the other by the cosine's
/// sign.
inline constexpr int kCosineSteps = 2500;

/// What decides the histogram bins of a pair: thresholds, instead of angles.
///
/// Angles are compared as signed squares q = c |c|, which takes no arccos and no root, where c is
/// kNormalScale times their cosine. An angle lies in column k if q is inside k of the nested
/// intervals [from, below).
struct PairBinning {
  static constexpr int kMaxEdges = 31;
  /// Scale of the bases' normals: |q| stays just below 8, and its whole part is its class, see
  /// ColumnTables.
  static constexpr float kNormalScale = 2.8284F;

  float sq_radius = 0;  ///< pairs beyond it are no neighbours [m^2]
  int rows = 1;
  int columns = 1;
  std::array<float, kMaxEdges> row_from{};      ///< rows - 1 squared distances, rising [m^2]
  std::array<float, kMaxEdges> column_below{};  ///< columns - 1 values of q, falling
  std::array<float, kMaxEdges> column_from{};   ///< likewise, rising; not folded: -infinity
  bool is_folded = true;  ///< columns are of 0 to 90 degrees, else of 0 to 180

  /// @param config  Valid.
  explicit PairBinning(const IronConfig& config, NormalSigns signs = NormalSigns::kArbitrary);

  int RowOf(float sq_distance) const {
    int row = 0;
    for (int k = 0; k < rows - 1; ++k) row += sq_distance >= row_from[k] ? 1 : 0;
    return row;
  }
  int ColumnOf(float q) const {
    int column = 0;
    for (int k = 0; k < columns - 1; ++k)
      column += q < column_below[k] && q >= column_from[k] ? 1 : 0;
    return column;
  }
};

/// The same columns by tables, for wide registers: classes k <= |q| < k + 1, each with at most one
/// edge. The squares of the paper's edges, cosines of multiples of 11.25 degrees, fall into one
/// class each.
///
/// |q| < edge is in column `least + 1`, else in `least`. The same by q itself, whose classes are
/// 0 to 7 for q >= 0 and -8 to -1, in places 8 to 15, for q < 0: 1 << 4 column is `increment_below`
/// if q < `signed_edge`, else `increment_from`.
struct ColumnTables {
  static constexpr int kMaxRows = 3;
  static constexpr int kMaxColumns = 8;

  bool valid = false;  ///< the binning is folded, of at most 3 rows, 8 columns, an edge a class
  std::array<std::int32_t, 8> least{};
  std::array<float, 8> edge_positive{};  ///< infinite where all are in `least + 1`
  std::array<float, 8> edge_negative{};  ///< for q < 0
  std::array<float, 16> signed_edge{};
  std::array<std::int32_t, 16> increment_below{};
  std::array<std::int32_t, 16> increment_from{};

  explicit ColumnTables(const PairBinning& binning);
};

}  // namespace fallen
