// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/body_shape.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// Cloth and hair from which next to no near infrared comes back: both kinds of sensor see holes
/// there, at grazing incidence and from afar first. Of one of two real persons on the floor a
/// Kinect 2 saw hardly a leg.
namespace fallen::sim {

/// Makes each of top, trousers and hair black with a chance in [0, 1]. Other draws stay as they
/// are.
void WearBlack(double chance, Random random, BodyShape& shape);

/// Makes a thing black, all of it, with a chance in [0, 1].
void CoverInBlack(double chance, Random random, TriangleMesh& mesh);

}  // namespace fallen::sim
