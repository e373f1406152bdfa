// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/cell_tiles.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/iron/pair_binning.hpp"
#include "fallen/iron/pair_counts.hpp"

namespace fallen {

/// Computes descriptors frame after frame in the same memory: see ComputeIronDescriptors.
///
/// What it found stays valid until the next call. Not thread-safe.
class IronDescriber {
 public:
  /// @throws std::invalid_argument if `config` is out of range.
  explicit IronDescriber(const IronConfig& config = {},
                         NormalSigns signs = NormalSigns::kArbitrary);

  const IronConfig& config() const { return config_; }

  /// @throws std::invalid_argument if sizes disagree.
  const IronDescriptors& Describe(std::span<const NdtCell> cells,
                                  std::span<const CellNormal> normals,
                                  std::span<const std::uint8_t> wanted = {});

  /// Indices of the usable cells, ascending.
  std::span<const std::int32_t> usable() const { return selected_; }
  /// The neighbourhoods of these; bases are the wanted ones.
  CellTiles& tiles() { return tiles_; }
  /// Index in `cells` of the usable cell at grid position `position`.
  std::int32_t cell_index(std::int32_t position) const {
    return selected_[tiles_.grid().sorted_index()[position]];
  }

 private:
  void SelectUsable(std::span<const NdtCell> cells, std::span<const CellNormal> normals,
                    std::span<const std::uint8_t> wanted);
  void DescribeTile(const CellTile& tile);

  IronConfig config_;
  PairBinning binning_;
  ColumnTables tables_;
  std::vector<std::int32_t> selected_;  // usable cells
  std::vector<Eigen::Vector3f> means_;  // theirs
  std::vector<std::uint8_t> is_base_;
  CellTiles tiles_;
  std::vector<PairCell> pair_cells_;  // usable cells in grid order
  std::vector<std::uint32_t> counts_;
  std::vector<float> shares_;  // descriptors of a tile, value by value
  IronDescriptors descriptors_;
};

}  // namespace fallen
