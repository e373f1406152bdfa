// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/picture/canvas.hpp"
#include "tools/picture/viewed_frame.hpp"

namespace fallen {

/// Draws the depth image in colours, with the boxes of all clusters as the camera sees them, and
/// the scale of the colours below.
void DrawDepthPanel(Canvas& canvas, const Area& area, const ViewedFrame& viewed);

}  // namespace fallen
