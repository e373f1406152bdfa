// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/geometry/plane.hpp"
#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// What stands on a disc of the floor.
struct ColumnSummary {
  float lowest_m = 0;   ///< least height of a cell's mean
  float highest_m = 0;  ///< greatest
  float mean_m = 0;
  float occupied_share = 0;  ///< of the disc's columns, those that hold a cell, [0, 1]
};

/// The cells of a map sorted into upright columns on a raster of the floor, 0.1 m wide.
///
/// Answers "what is above and below this cell" without a search in space. Discs are made of whole
/// columns, so their edges follow the raster, and all cells of a column share their summaries. Not
/// thread-safe: summaries are remembered.
class HeightColumns {
 public:
  /// No columns.
  HeightColumns() = default;
  /// @param ground  Floor in the cells' frame, normal up.
  /// @throws std::invalid_argument if a cell's mean is not finite.
  HeightColumns(std::span<const NdtCell> cells, const Plane& ground) { Build(cells, ground); }

  /// Starts anew, in the memory that is there: as the constructor.
  void Build(std::span<const NdtCell> cells, const Plane& ground);

  /// Height of cell `i`'s mean above the floor [m].
  float height_m(std::size_t i) const { return heights_m_[i]; }

  /// Summary of the columns whose centres lie within `radius_m` of the centre of cell `i`'s column;
  /// its own is always among them.
  const ColumnSummary& Summarize(std::size_t i, float radius_m) const;

 private:
  struct Column {
    float lowest_m, highest_m;  // infinities in a column without cells
    float sum_m;
    std::int32_t count;
  };
  // The summaries that were asked for with one radius.
  struct Disc {
    float radius_m;
    std::vector<std::int32_t> half_widths;    // columns to either side, by row from the middle
    std::vector<ColumnSummary> summaries;     // by column
    std::vector<std::uint8_t> is_summarized;  // likewise
  };

  Disc& DiscOf(float radius_m) const;
  ColumnSummary SummarizeColumn(std::int32_t column, const Disc& disc) const;

  float width_m_ = 0;
  Eigen::Array2i size_ = Eigen::Array2i::Zero();
  std::vector<Column> columns_;  // row by row
  std::vector<std::int32_t> column_of_cell_;
  std::vector<float> heights_m_;
  std::vector<Eigen::Array2d> places_;
  mutable std::vector<Disc> discs_;
};

}  // namespace fallen
