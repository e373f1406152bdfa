// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// Takes persons out of a depth image: the pixels that `truth` labels as a person, and those whose
/// points lie in a person's box or close to it. So they leave no trace in a map of the place.
/// @return Number of measurements taken out.
std::int64_t RemovePersons(DepthImage& image, const GroundTruth& truth,
                           const Eigen::Isometry3d& T_world_camera);

}  // namespace fallen
