// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/baseline/baseline_config.hpp"
#include "fallen/baseline/surface_cloud.hpp"
#include "fallen/segmentation/boosted_trees.hpp"

namespace fallen {

/// Number of columns of ComputeLayerFeatures that are about the cluster as a whole.
inline constexpr int kClusterGeometryFeatures = 13;

/// Number of columns of ComputeLayerFeatures.
int LayerFeatureCount(const BaselineConfig& config);

/// Describes a cluster by its layers, lowest first, and by its shape as a whole.
///
/// With a the cluster's main axis on the floor and b the one across it:
/// | columns of a layer | value                                                               |
/// |--------------------|---------------------------------------------------------------------|
/// | 0 .. bins - 1      | normals n: histogram of abs(n.a) over [0, 1]   [Hegger12]           |
/// | .. 2 bins - 1      | of abs(n.b) over [0, 1]                                             |
/// | .. 3 bins - 1      | of n.z over [-1, 1]                                                 |
/// | next three         | share of the cluster's points; extent along a and along b [m]       |
/// A histogram is divided by the number of normals in it; without any it is zero. Axes have no
/// sign, so neither have components along them. Binning along the cluster's axes is ours: a person
/// lies in any direction, where [Hegger12] looks for persons who stand.
/// | after the layers | value                                                                 |
/// |------------------|-----------------------------------------------------------------------|
/// | 0                | surface: points times leaf^2 [m^2]                                    |
/// | 1 - 3            | extent along a, along b, height from lowest to highest [m]            |
/// | 4 - 8            | height above the floor: least, mean, deviation, lower and upper       |
/// |                  | quartile [m]                                                          |
/// | 9 - 10           | standard deviation along a and along b [m]                            |
/// | 11 - 12          | distance of the camera along the floor, its height above it [m]       |
/// @param cluster          At least one point.
/// @param camera_height_m  The camera is above the frame's origin.
/// @throws std::invalid_argument without points, or if there are not as many normals. All finite.
/// Deterministic. O(n log n).
Eigen::RowVectorXf ComputeLayerFeatures(const SurfaceCloud& cluster, double camera_height_m,
                                        const BaselineConfig& config);

}  // namespace fallen
