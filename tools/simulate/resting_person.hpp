// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tools/simulate/human_model.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/scene.hpp"

namespace fallen::sim {

/// Kinds of distractor: somebody asleep on a sofa or a bed, or seated on a piece of furniture that
/// is in the room. Neither is a fall.
inline constexpr char kResting[] = "resting_person";
inline constexpr char kSeated[] = "seated_person";

/// Lays a person on one of the scene's sofas or beds, along its longer side.
/// @return Nothing if the scene has neither.
std::optional<SceneObject> MakeRestingPerson(const HumanModel& humans, const Scene& scene,
                                             Random& random);

/// Seats a person on one of the scene's chairs, armchairs, sofas or beds.
/// @return Nothing if the scene has none.
std::optional<SceneObject> MakeSeatedPerson(const HumanModel& humans, const Scene& scene,
                                            Random& random);

}  // namespace fallen::sim
