// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_cell.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

/// What a recording shows of its place.
struct RecordingMap {
  std::vector<NdtCell> cells;  ///< world frame, without floor and persons
  std::int64_t frames = 0;     ///< used
  std::int64_t without_pose = 0;
  std::int64_t damaged = 0;
};

/// Maps the whole of a recording, without bounds in space or time. Labelled persons are left out.
///
/// Frames without a pose are passed over. The floor is found by `ground`, else taken to be z = 0,
/// as poses are in a world with the floor there.
/// @param ndt   Cell size, range and clearances; its extent and time gap are not heeded.
/// @param name  Of the recording, for errors.
/// @throws std::runtime_error if no frame has a pose.
RecordingMap MapRecording(FrameSource& recording, const GroundConfig& ground, const NdtConfig& ndt,
                          const std::string& name);

}  // namespace fallen
