// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fallen/geometry/oriented_box.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// Number of columns of ComputeClusterFeatures before the code.
inline constexpr int kClusterShapeFeatures = 47;

/// What a cluster looks like as a whole: size, height, outline, surroundings, and its code.
///
/// Goes beyond the paper, whose code says what the surface is like but not how large or how high.
/// | column  | value                                                                          |
/// |---------|--------------------------------------------------------------------------------|
/// | 0       | logarithm of the number of cells                                               |
/// | 1 - 3   | mean, largest and standard deviation of the cells' scores                      |
/// | 4       | logarithm of the Mahalanobis distance                                          |
/// | 5 - 10  | height above the floor: least, mean, greatest, deviation, lower, upper quartile|
/// | 11 - 14 | box: length, width, height [m], width / length                                 |
/// | 15 - 16 | standard deviation along and across the main axis on the floor [m]             |
/// | 17 - 18 | area of the cells' footprint [m^2], share of the box that it fills             |
/// | 19 - 21 | cosine of normals to the vertical: mean, share above 0.9, share below 0.3      |
/// | 22 - 23 | mean of lambda0 / lambda1 and lambda1 / lambda2 of the cells                   |
/// | 24 - 25 | distance of the camera along the floor, its height above it [m]                |
/// | 26 - 30 | other cells relative to the cluster's own: in the box and 0.1 m around it;     |
/// |         | above that, up to 0.5 m; below; 0.1 to 0.4 m beside; mean score of the first   |
/// | 31 - 45 | five slices along the box, from its heavier half: share of the cells, greatest |
/// |         | height [m], width [m]                                                          |
/// | 46      | share of the cells under 0.12 m                                                |
/// | 47 ...  | `code`                                                                         |
/// @param box   FitUprightBox of the cluster.
/// @param code  EncodeCluster of the cluster.
/// @throws std::invalid_argument for a cluster without cells or a map without a floor. All finite.
/// Deterministic. O(cells of the map).
Eigen::RowVectorXf ComputeClusterFeatures(const SegmentedMap& segmented, const CellCluster& cluster,
                                          const OrientedBox& box, const Eigen::VectorXd& code,
                                          double mahalanobis_distance);

}  // namespace fallen
