// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fallen/segmentation/background_subtraction.hpp"
#include "tools/view/scene/cell_ages.hpp"
#include "tools/view/scene/scene.hpp"

namespace fallen {

/// A frame for the page, as PageMessage.
///
/// Facts; what is not known is left out:
///
/// | name            | value                                                                     |
/// |-----------------|---------------------------------------------------------------------------|
/// | kind            | "frame"                                                                   |
/// | index           | its number in the feed, from 0                                            |
/// | utime, seq, camera | as in header_t                                                         |
/// | intrinsics      | width, height, fx, fy, cx, cy of the camera [px]                          |
/// | depth           | width, height of the array `depth`, a thinned image                       |
/// | frame           | MapFrame: "world", "level", "camera"                                      |
/// | T_map_camera    | 12 numbers, 3 x 4 row-major                                               |
/// | ground          | status, method, normal, offset (map frame)                                |
/// | background      | BackgroundStatus                                                          |
/// | cells           | count, origin, place_step_m, root_step_m: see CellTexels                  |
/// | min_probability | threshold in force; with it, `persons`                                    |
/// | persons         | centroid, box (center, size, yaw), probability, distance, cells,          |
/// |                 | mean_score, is_person; best first                                         |
/// | milliseconds    | by stage                                                                  |
/// | truth           | box of the labelled person                                                |
///
/// Arrays: `depth`, uint16, millimetres, row-major, 0 = no measurement; `texels`, int16, of
/// CellTexels.
///
/// @param ages  Knows the frames before this one.
std::vector<std::uint8_t> SceneToMessage(const Scene& scene, std::int64_t index, CellAges& ages);

/// The environment map for the page: `kind` "environment", `cells`, array `texels`.
std::vector<std::uint8_t> EnvironmentToMessage(const EnvironmentMap& environment);

}  // namespace fallen
