// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/ndt/ndt_map.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/shape_features.hpp"

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
/// Columns: the descriptor, D = iron.dimension() values; for kIronAndShape also, in column D, the
/// neighbours of the descriptor, relative to a closed plane of cells, and then the columns of
/// ComputeShapeFeatures. Always finite.
/// @throws std::invalid_argument if sizes disagree or an index is out of range.
/// Deterministic. Thread-safe. O(cells + indices).
FeatureMatrix ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                                  const IronDescriptors& descriptors,
                                  std::span<const std::int32_t> indices, CellFeatureSet features);

/// Number of columns of ComputeCellFeatures.
int CellFeatureCount(const IronConfig& iron, CellFeatureSet features);

/// ComputeCellFeatures of kIronAndShape, of shapes that are known, into memory that is there.
/// @param shapes  Columns of ComputeShapeFeatures.
/// @param shape_rows  Row in `shapes` of each cell of `indices`.
/// @param matrix  Given as many rows as there are indices, and perhaps some more.
void JoinCellFeatures(const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                      const FeatureMatrix& shapes, std::span<const std::int32_t> shape_rows,
                      double cell_size_m, FeatureMatrix& matrix);

/// ComputeCellFeatures of kIron, likewise.
void TakeDescriptors(const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                     FeatureMatrix& matrix);

}  // namespace fallen
