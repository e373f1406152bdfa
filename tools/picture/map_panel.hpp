// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/picture/canvas.hpp"
#include "tools/picture/viewed_frame.hpp"

namespace fallen {

/// Draws the NDT map as ellipsoids, seen from behind and above the camera: cells coloured by score,
/// the boxes of all clusters, a metre grid on the floor, and what the colours mean.
void DrawMapPanel(Canvas& canvas, const Area& area, const ViewedFrame& viewed);

}  // namespace fallen
