// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "fallen/geometry/oriented_box.hpp"
#include "tools/picture/canvas.hpp"
#include "tools/picture/viewed_frame.hpp"

namespace fallen {

/// A box to draw, in the frame of the map.
struct DrawnBox {
  OrientedBox box;
  Color color;
  double line_width = 1;
  std::string label;  ///< "" for none
};

/// The boxes of a frame: ground truth, other clusters, accepted persons; the last are on top.
std::vector<DrawnBox> BoxesToDraw(const ViewedFrame& viewed);

/// Draws the box's edges and its label. `project` maps a point of the map to the canvas.
/// @param clip_edge  Cuts an edge to what can be projected; false if nothing of it can.
void DrawBox(Canvas& canvas, const DrawnBox& box,
             const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& project,
             const std::function<bool(Eigen::Vector3d&, Eigen::Vector3d&)>& clip_edge);

}  // namespace fallen
