// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/geometry/kept_vector.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// A segmented map and what all of its clusters' features need of each cell, computed once.
///
/// Refers to the map, which must outlive it.
struct ClusterScene {
  /// @throws std::invalid_argument for a map without a floor.
  explicit ClusterScene(const SegmentedMap& segmented);

  const SegmentedMap& segmented;
  KeptVector<float> heights_m;     ///< of the cells' means above the floor
  KeptVector<CellNormal> normals;  ///< of the map's members
  /// Where the cells that belong to a cluster are among the members; the rest means nothing.
  KeptVector<std::int32_t> member_of_cell;
};

}  // namespace fallen
