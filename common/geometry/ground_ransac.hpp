// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fallen/geometry/ground_check.hpp"

namespace fallen {

/// Finds the best supported plane under which (almost) nothing lies, [Fischler81] with PCL's plane.
///
/// Departs from plain RANSAC: triples are drawn from surfaces that could be a floor by their
/// direction and must agree with it, and each plane that beats the best one is refined before it is
/// compared. The largest plane of a room is often a wall, a table or a bed.
std::optional<Floor> FindFloorByRansac(const GroundScene& scene, const GroundPrior& prior,
                                       const GroundConfig& config);

}  // namespace fallen
