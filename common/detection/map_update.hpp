// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/detection/frame.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_mapper.hpp"

namespace fallen {

/// First stage, shared by the mapping service and the detector: ground, pose, map.
///
/// The camera's pose is known where both the robot's pose and the mounting are; the map is in the
/// world frame then, and in a frame of the camera's otherwise.
/// @param milliseconds  If given, its `ground` and `ndt` are set.
/// @throws std::invalid_argument if the image, a transform or `config` is out of range.
NdtMap UpdateMap(NdtMapper& mapper, const Frame& frame, const GroundConfig& config,
                 StageTimes* milliseconds = nullptr);
/// Likewise, into memory that is there.
void UpdateMap(NdtMapper& mapper, const Frame& frame, const GroundConfig& config, NdtMap& map,
               StageTimes* milliseconds = nullptr);

}  // namespace fallen
