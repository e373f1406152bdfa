// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fallen/geometry/ground_check.hpp"

namespace fallen {

/// Finds the floor as a line in the histogram of rows and inverse depths, [Labayrade02].
///
/// Departs from the paper: only points on surfaces that could be a floor by their direction take
/// part, which keeps walls out; rows are turned by the camera's roll, known from the mounting
/// (`roll_known`) or else from those surfaces; and of the lines the longest one below which
/// (almost) nothing lies is taken.
std::optional<Floor> FindFloorByVDisparity(const GroundScene& scene, const GroundPrior& prior,
                                           bool roll_known, const GroundConfig& config);

}  // namespace fallen
