// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// The baseline's steps that PCL does. Points [m], all in one frame, all finite.
namespace fallen {

/// One point, the mean, for each voxel of edge `leaf_m` that holds points: pcl::VoxelGrid.
std::vector<Eigen::Vector3f> ThinPoints(const std::vector<Eigen::Vector3f>& points, double leaf_m);

/// Normals of the planes through each point's neighbours within `radius_m`, towards `viewpoint`:
/// pcl::NormalEstimation. Zero for a point with fewer than three neighbours, itself included.
std::vector<Eigen::Vector3f> EstimateNormals(const std::vector<Eigen::Vector3f>& points,
                                             const Eigen::Vector3f& viewpoint, double radius_m);

/// Sets of points that hang together by steps of at most `tolerance_m`, each with at least
/// `min_points`: pcl::EuclideanClusterExtraction. Indices ascend; larger clusters come first (ties:
/// the one with the smaller index).
std::vector<std::vector<std::int32_t>> EuclideanClusters(const std::vector<Eigen::Vector3f>& points,
                                                         double tolerance_m, int min_points);

}  // namespace fallen
