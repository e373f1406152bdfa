// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fallen/geometry/oriented_box.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// About the length of a tall person, arms not stretched [m].
inline constexpr double kPersonLength_m = 2.0;

/// Parts of a cluster that may be a person alone, where the whole is a person joined with the dog
/// beside him or the sofa that he lies against.
///
/// Goes beyond the paper, which judges whole clusters. Two kinds:
/// - what DBSCAN makes of the members whose score is at least 1/3, and 2/3, of the cluster's high
///   scores (their 95 % quantile),
/// - of a cluster longer or wider than a person, its halves and quarters, by 2-means along the
///   floor.
/// Parts overlap each other; each has at least 40 members and at most 95 % of the whole's.
/// @param box  FitUprightBox of the cluster.
/// Deterministic. Thread-safe.
std::vector<CellCluster> FindClusterParts(const SegmentedMap& segmented, const CellCluster& cluster,
                                          const OrientedBox& box);

}  // namespace fallen
