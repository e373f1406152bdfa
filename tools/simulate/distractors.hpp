// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/simulate/furniture_catalogue.hpp"
#include "tools/simulate/human_model.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/scene.hpp"

namespace fallen::sim {

/// Somebody on their feet; also what becomes of a fallen person who gets up.
inline constexpr char kStandingPerson[] = "standing_person";

/// Things and beings that a careless detector takes for a fallen person.
const std::vector<std::string>& DistractorKinds();

struct Distractor {
  std::string category;  ///< the kind
  std::string name;
  TriangleMesh mesh;  ///< resting on z = 0, around the origin
};

/// Makes one of a kind. @throws std::invalid_argument for an unknown kind.
Distractor MakeDistractor(const std::string& kind, const FurnitureCatalogue& catalogue,
                          const HumanModel& humans, FurniturePool pool, Random& random);

/// Blanket, clothes or duvet, dropped or folded: a heap with folds.
TriangleMesh MakeHeap(const Eigen::Vector3d& size, double fold_length_m, Random& random);

TriangleMesh MakeVacuumCleaner(Random& random);

/// A walking frame with four wheels.
TriangleMesh MakeRollator(Random& random);

}  // namespace fallen::sim
