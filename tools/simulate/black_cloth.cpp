// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/black_cloth.hpp"

#include <cmath>

namespace fallen::sim {
namespace {

// A nominal sensor loses half of the pixels of cloth that faces it from 1.5 to 4.7 m away.
double DrawBlackAlbedo(Random& random) {
  return std::exp(random.Uniform(std::log(0.004), std::log(0.04)));
}

}  // namespace

void WearBlack(double chance, Random random, BodyShape& shape) {
  for (double* const albedo : {&shape.top_albedo, &shape.legs_albedo, &shape.hair_albedo}) {
    const bool black = random.Chance(chance);
    const double drawn = DrawBlackAlbedo(random);
    if (black) *albedo = drawn;
  }
}

void CoverInBlack(double chance, Random random, TriangleMesh& mesh) {
  if (random.Chance(chance)) mesh.SetAlbedo(DrawBlackAlbedo(random));
}

}  // namespace fallen::sim
