// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/simulate/body_shape.hpp"
#include "tools/simulate/lying_poses.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/simulate/settling.hpp"

namespace fallen::sim {

/// A thing that belongs to how somebody lies.
struct Prop {
  std::string name;
  TriangleMesh mesh;
};

struct PersonMesh {
  TriangleMesh mesh;    ///< dressed, resting on z = 0, pelvis above the origin
  SettledPose settled;  ///< how well it lies
  std::vector<Prop> props;
};

/// A person who lies on the floor, head towards +x, before being placed: with the chair below the
/// legs, the furniture behind the back or the obstacle at the feet, where the family has one.
PersonMesh MakeLyingPerson(const HumanModel& model, const BodyShape& shape, PoseFamily family,
                           Random& random);

/// A person who stands, facing +x.
TriangleMesh MakeStandingPerson(const HumanModel& model, const BodyShape& shape, Random& random);

/// A person who sits, facing +x, the buttocks at `seat_height_m` above the origin.
TriangleMesh MakeSittingPerson(const HumanModel& model, const BodyShape& shape,
                               double seat_height_m, Random& random);

/// Low, but on one's feet or knees.
enum class Stoop {
  kKneeling,   ///< on both knees
  kBending,    ///< reaches for the floor with nearly straight legs
  kCrouching,  ///< squats, to tie a shoe
};

/// A person who stoops, facing +x.
TriangleMesh MakeStoopingPerson(const HumanModel& model, const BodyShape& shape, Stoop stoop,
                                Random& random);

}  // namespace fallen::sim
