// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/random.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// What belongs to how somebody lies. Frame `lying`, see lying_poses.hpp; `person` is the dressed
/// body at rest.
namespace fallen::sim {

/// A chair or something solid below legs that are laid up.
TriangleMesh MakeSeatBelowLegs(const TriangleMesh& person, Random& random);

/// A piece of furniture that the back of somebody half sitting leans against.
TriangleMesh MakeBackrest(const TriangleMesh& person, Random& random);

/// What the person has stumbled over, at the feet: a walker on its side, a box, a rolled carpet.
TriangleMesh MakeObstacle(const TriangleMesh& person, Random& random);

/// A blanket that covers the person from the feet to somewhere between thighs and chest.
TriangleMesh MakeBlanketOver(const TriangleMesh& person, Random& random);

}  // namespace fallen::sim
