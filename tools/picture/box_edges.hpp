// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// The eight corners: bit 0 of the index tells the side in x, bit 1 in y, bit 2 in z.
std::array<Eigen::Vector3d, 8> BoxCorners(const OrientedBox& box);

/// The twelve edges, as indices of corners.
std::array<std::pair<int, int>, 12> BoxEdges();

}  // namespace fallen
