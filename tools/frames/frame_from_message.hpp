// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "fallen/detection/frame.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// The frame that a depth image makes, still without the robot's pose.
inline Frame ToFrame(StampedDepthImage depth) {
  Frame frame;
  frame.utime = depth.header.utime;
  frame.seq = depth.header.seq;
  frame.sensor_name = std::move(depth.header.sensor_name);
  frame.image = std::move(depth.image);
  frame.T_robot_camera = depth.T_robot_camera;
  return frame;
}

}  // namespace fallen
