// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/ndt/ndt_map.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/height_columns.hpp"

namespace fallen {

/// Columns of ComputeShapeFeatures.
inline constexpr int kShapeFeatureCount = 10;

/// What is known of a cell without a descriptor, and the memory of it, kept from frame to frame.
struct ShapeFeatures {
  FeatureMatrix matrix;   ///< as many rows as there are indices, and perhaps some more
  HeightColumns columns;  ///< of the map, if its floor is known
};

/// A cell's shape, its height above the floor and what stands around, one row a cell of `indices`.
///
/// | column | value                                                                      |
/// |--------|----------------------------------------------------------------------------|
/// | 0      | lambda0 / lambda1 of the cell's covariance: flat 0, round 1                |
/// | 1      | lambda1 / lambda2: long 0, broad 1                                         |
/// | 2      | sqrt(lambda2), the cell's largest standard deviation [m]                   |
/// | 3      | height of the mean above the floor [m]                                     |
/// | 4      | cosine between normal and vertical, [0, 1]: 1 for the top of a table       |
/// | 5      | how far the highest cell within 0.25 m along the floor rises above it [m]  |
/// | 6      | how far the lowest cell there lies below it [m]                            |
/// | 7      | height of the highest cell within 0.5 m along the floor [m]                |
/// | 8      | mean height of the cells there [m]                                         |
/// | 9      | share of the floor there that has cells above it, [0, 1]                   |
///
/// Columns 3 to 9 need a floor: without one (`!map.ground.ok()`) they are 0. Always finite. Every
/// cell of `map` counts for 5 to 9, at the resolution of HeightColumns.
/// @param normals  One a cell of `map`.
/// @param indices  In range.
/// Deterministic. O(cells + indices).
void ComputeShapeFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                          std::span<const std::int32_t> indices, ShapeFeatures& result);

}  // namespace fallen
