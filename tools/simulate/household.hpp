// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/random.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// Things that lie or stand about in a flat, from primitives, around the origin.
namespace fallen::sim {

TriangleMesh MakeCushion(Random& random);
TriangleMesh MakeCardboardBox(Random& random);
/// A soft bag: fatter below, with two handles.
TriangleMesh MakeSportsBag(Random& random);
/// A backpack that leans against or lies beside a carpet bag: as long as somebody curled up.
TriangleMesh MakeBackpackAndBag(Random& random);
TriangleMesh MakeAirMattress(Random& random);
/// Upright or laid down, with wheels and handle.
TriangleMesh MakeSuitcase(Random& random);
TriangleMesh MakeRolledCarpet(Random& random);
/// One to four pairs.
TriangleMesh MakeShoes(Random& random);
TriangleMesh MakeToys(Random& random);
TriangleMesh MakeLaundryBasket(Random& random);

}  // namespace fallen::sim
