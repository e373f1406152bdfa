// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// What a cell's colour may tell.
struct CellMark {
  std::optional<float> score;  ///< nothing: without a descriptor
  std::int32_t cluster = -1;
  double age_s = 0;
  bool is_foreground = true;
};

/// Cells as a graphics card takes them: a texture with three texels of four 16-bit numbers a cell.
///
/// An ellipsoid is the image of the unit sphere under a root L of the covariance, C = L L', times
/// the number of sigmas: any root gives the same ellipsoid, and the lower triangular one has six
/// numbers and needs no eigenvectors. The other side is tools/view/page/scene/cell_shader.js.
///
/// | texel | 0    | 1    | 2    | 3                                                         |
/// |-------|------|------|------|-----------------------------------------------------------|
/// | 0     | x    | y    | z    | cluster; -1 = none, -2 = known background                 |
/// | 1     | L xx | L yx | L yy | score * 32767; -32768 = without a descriptor              |
/// | 2     | L zx | L zy | L zz | tenths of a second since the cell last took points in     |
struct CellTexels {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< map frame [m]
  double place_step_m = 1;                           ///< mean = origin + place_step_m * (x, y, z)
  double root_step_m = 1;                            ///< of L
  std::vector<std::int16_t> texels;                  ///< 12 a cell

  static constexpr std::size_t kNumbersPerCell = 12;
  std::size_t count() const { return texels.size() / kNumbersPerCell; }
};

/// Quantises cells: to 2^-15 of the largest distance from their middle, and of the largest root.
/// @param marks  One a cell, or none at all.
CellTexels ToCellTexels(std::span<const NdtCell> cells, std::span<const CellMark> marks);

}  // namespace fallen
