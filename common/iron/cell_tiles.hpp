// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/neighbor_grid.hpp"
#include "fallen/simd/lanes.hpp"

namespace fallen {

/// Cells that lie close together and so have most of their neighbours in common.
struct CellTile {
  std::int32_t begin = 0, end = 0;  ///< in CellTiles::bases(), at most kMostLanes
  Eigen::Array3f low, high;         ///< box around their means
};

/// The neighbourhoods of a map, found once and used by descriptors and smoothing alike.
///
/// The cells are sorted into a grid. Those whose neighbourhoods are wanted, the bases, are taken
/// together in tiles, so that the search for neighbours is made once a tile and each neighbour is
/// loaded once for all its bases.
class CellTiles {
 public:
  /// Sorts the cells with these means.
  /// @param is_base   One flag a point.
  /// @param radius_m  The radius that is searched most.
  /// @throws std::invalid_argument for points that NeighborGrid refuses.
  void Build(std::span<const Eigen::Vector3f> points, std::span<const std::uint8_t> is_base,
             float radius_m);

  const NeighborGrid& grid() const { return grid_; }
  std::span<const CellTile> tiles() const { return tiles_; }
  /// Positions in the grid of the bases, tile by tile.
  std::span<const std::int32_t> bases() const { return bases_; }
  std::span<const std::int32_t> bases_of(const CellTile& tile) const {
    return std::span(bases_).subspan(tile.begin, tile.end - tile.begin);
  }

  /// Finds every cell within `radius_m` of the tile's bases, and some others near the tile. Each
  /// base meets its neighbours in an order that depends on the points and `radius_m` alone.
  /// @return  Positions in the grid; they hold until the next call.
  std::span<const std::int32_t> FindNear(const CellTile& tile, float radius_m);

 private:
  void SortBases(std::span<const std::uint8_t> is_base, float step_m);
  void CutTiles(float max_extent_m);

  NeighborGrid grid_;
  std::vector<float> x_, y_, z_;  // of the sorted points, and room to read on
  std::vector<std::int32_t> bases_, sorted_bases_;
  std::vector<std::uint32_t> keys_, sorted_keys_;
  std::vector<CellTile> tiles_;
  std::vector<CellRun> runs_;       // of FindNear
  std::vector<std::int32_t> near_;  // likewise
};

}  // namespace fallen
