// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "fallen/geometry/camera_view.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// Share of `box` that a camera sees, [0, 1]: of 15 points across it at half its height, those
/// whose ray was measured and did not end more than `margin_m` before them.
/// @param box  In the frame `map`.
/// @return Nothing if the view is not known.
std::optional<double> VisibleShare(const CameraView& view, const Eigen::Isometry3d& T_map_camera,
                                   const OrientedBox& box, double margin_m);

}  // namespace fallen
