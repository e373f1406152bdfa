// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/random.hpp"
#include "tools/simulate/scene.hpp"

namespace fallen::sim {

/// Moves a share of a room's furniture, as its people do after a map of it was made: each of the
/// pieces stands half a metre or more from where it was, still parallel to the walls if it was, on
/// free floor. The objects keep their order; a piece for which there is no other place stays.
/// @param share  Of the pieces, [0, 1]; rounded to whole ones.
/// @return How many were moved.
int MoveFurniture(Scene& scene, double share, Random& random);

}  // namespace fallen::sim
