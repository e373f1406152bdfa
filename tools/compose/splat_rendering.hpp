// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "fallen/geometry/camera_intrinsics.hpp"
#include "tools/compose/person_cloud.hpp"

namespace fallen {

/// Renders a surface of splats as a depth camera would see it, in the way of [Zwicker01].
///
/// [Zwicker01] Zwicker, Pfister, van Baar, Gross: Surface splatting. SIGGRAPH 2001.
///
/// A pixel's depth is the mean of the discs that its ray meets near the foremost one, weighted by
/// their Gaussians. Where too few overlap there is no surface: so outlines stay where the points
/// end, and no hole appears between points however near the camera is.
/// @return Depth along the optical axis [m], row-major, one value a pixel; 0 where nothing is.
std::vector<double> RenderSplats(std::span<const Splat> splats, const CameraIntrinsics& camera,
                                 const Eigen::Isometry3d& T_camera_splats);

}  // namespace fallen
