// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fallen/baseline/baseline_config.hpp"
#include "fallen/geometry/depth_image.hpp"
#include "fallen/geometry/plane.hpp"

namespace fallen {

/// The points of an image that are not the floor's and not too high [Volkhardt13], in the frame
/// `level` of LevelFrameFromGround [m], row by row.
/// @param ground_camera  Floor in the camera frame, normal up.
/// @throws std::invalid_argument if the image is malformed.
std::vector<Eigen::Vector3f> GroundFreePoints(const DepthImage& image, const Plane& ground_camera,
                                              const BaselineConfig& config);

}  // namespace fallen
