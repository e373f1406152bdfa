// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/ndt/ndt_map.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/height_columns.hpp"

namespace fallen {

/// What the cell classifier looks at.
enum class CellFeatureSet : std::int32_t {
  kIron = 0,          ///< the descriptor alone: the paper
  kIronAndShape = 1,  ///< and the cell's shape, its height above the floor and what stands around
};
constexpr auto EnumNames(CellFeatureSet) {
  return EnumTable<CellFeatureSet, 2>{
      {{CellFeatureSet::kIron, "iron"}, {CellFeatureSet::kIronAndShape, "iron_and_shape"}}};
}

/// Features of the cells that have a descriptor, one row a cell of `indices`. Shared by training
/// and use.
///
/// Columns: the descriptor, D = iron.dimension() values; for kIronAndShape also
///
/// | column | value                                                                          |
/// |--------|--------------------------------------------------------------------------------|
/// | D + 0  | lambda0 / lambda1 of the cell's covariance: flat 0, round 1                    |
/// | D + 1  | lambda1 / lambda2: long 0, broad 1                                             |
/// | D + 2  | sqrt(lambda2), the cell's largest standard deviation [m]                       |
/// | D + 3  | neighbours of the descriptor, relative to a closed plane of cells              |
/// | D + 4  | height of the mean above the floor [m]                                         |
/// | D + 5  | cosine between normal and vertical, [0, 1]: 1 for the top of a table           |
/// | D + 6  | how far the highest cell within 0.25 m along the floor rises above this one [m]|
/// | D + 7  | how far the lowest cell there lies below it [m]                                |
/// | D + 8  | height of the highest cell within 0.5 m along the floor [m]                    |
/// | D + 9  | mean height of the cells there [m]                                             |
/// | D + 10 | share of the floor there that has cells above it, [0, 1]                       |
///
/// D + 4 to D + 10 need a floor: without one (`!map.ground.ok()`) they are 0. Always finite. Every
/// cell of `map` counts for D + 6 to D + 10, at the resolution of HeightColumns.
/// @throws std::invalid_argument if sizes disagree or an index is out of range.
/// Deterministic. Thread-safe. O(cells + indices).
FeatureMatrix ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                                  const IronDescriptors& descriptors,
                                  std::span<const std::int32_t> indices, CellFeatureSet features);

/// Number of columns of ComputeCellFeatures.
int CellFeatureCount(const IronConfig& iron, CellFeatureSet features);

/// Memory of ComputeCellFeatures, kept from frame to frame.
struct CellFeatures {
  FeatureMatrix matrix;   ///< as many rows as there are indices, and perhaps some more
  HeightColumns columns;  ///< of the map, if its floor is known
};

/// Likewise, into memory that is there.
void ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                         const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                         CellFeatureSet features, CellFeatures& result);

}  // namespace fallen
