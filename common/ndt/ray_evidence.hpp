// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/ndt/symmetric_eigen.hpp"

/// Evidence that a voxel is free: rays that went through it and ended behind it.
///
/// Gathered from the voxel's side: a few rays are looked up where it projects into the image,
/// instead of following every ray through the grid.
///
/// [Saarinen13]  Saarinen, Andreasson, Stoyanov, Lilienthal: 3D normal distributions transform
///               occupancy maps. IJRR 32(14), 2013.
/// [Nguyen12]    Nguyen, Izadi, Lovell: Modeling Kinect sensor noise for improved 3D reconstruction
///               and tracking. 3DIMPVT 2012.
namespace fallen {

/// Rays looked up for one voxel.
inline constexpr int kRaysPerVoxel = 5;

/// How many of the voxel's rays went through its Gaussian, in [0, kRaysPerVoxel].
///
/// Each ray counts with the likelihood of the Gaussian's most likely point on it, relative to the
/// mean's, and with how surely it ended behind that point [Saarinen13]. The Gaussian is widened by
/// a pixel's footprint, and behind means behind by more than the depth noise [Nguyen12] and the
/// Gaussian's own depth along the ray: so noise, grazing rays and the edges of things are no
/// evidence. Pixels without depth are none either.
/// @param mean         Camera frame [m].
/// @param covariance   Camera frame [m^2], need not be invertible.
/// @param cell_size_m  Spreads the rays over the voxel.
double CountRaysThrough(const DepthImage& image, const Eigen::Vector3d& mean,
                        const SymmetricMatrix3& covariance, double cell_size_m);

/// False if none of these rays ended behind the mean, so that CountRaysThrough is 0: most voxels
/// are hidden, or in front of everything.
bool AnyRayEndsBehind(const DepthImage& image, const Eigen::Vector3d& mean, double cell_size_m);

/// True if the ray through the voxel's centre ended more than a cell behind it: for voxels that
/// hold no Gaussian yet.
bool RayPassesCenter(const DepthImage& image, const Eigen::Vector3d& center, double cell_size_m);

}  // namespace fallen
