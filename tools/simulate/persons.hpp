// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/body_shape.hpp"
#include "tools/simulate/lying_poses.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/simulate/settling.hpp"

namespace fallen::sim {

struct PersonMesh {
  TriangleMesh mesh;    ///< dressed, resting on z = 0, pelvis above the origin
  SettledPose settled;  ///< how well it lies
};

/// A person who lies on the floor, head towards +x, before being placed.
PersonMesh MakeLyingPerson(const HumanModel& model, const BodyShape& shape, PoseFamily family,
                           Random& random);

/// A person who stands, facing +x.
TriangleMesh MakeStandingPerson(const HumanModel& model, const BodyShape& shape, Random& random);

/// A person who sits, facing +x, the buttocks at `seat_height_m` above the origin.
TriangleMesh MakeSittingPerson(const HumanModel& model, const BodyShape& shape,
                               double seat_height_m, Random& random);

}  // namespace fallen::sim
