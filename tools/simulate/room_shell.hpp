// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/random.hpp"
#include "tools/simulate/triangle_mesh.hpp"

namespace fallen::sim {

/// Walls, floor and ceiling as they are lived in: surfaces that reflect as they like, one or two
/// doors (shut, or open to a corridor behind, with a threshold), dark windows, skirting boards and
/// rugs of up to a centimetre. Frame and meaning as MakeShell's.
TriangleMesh MakeRoomShell(const Eigen::Vector2d& room_size, double height_m, Random& random);

}  // namespace fallen::sim
