// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/random.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// Dogs of tubes, from a beagle to a great dane, facing +x, feet or belly on z = 0.
namespace fallen::sim {

TriangleMesh MakeLyingDog(Random& random);
TriangleMesh MakeSittingDog(Random& random);
/// Stands or walks: one stride is frozen.
TriangleMesh MakeStandingDog(Random& random);

}  // namespace fallen::sim
