// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/simulate/body_pose.hpp"
#include "tools/simulate/lying_poses.hpp"

namespace fallen::sim {

/// A pose at rest on the floor, and how good the rest is.
struct SettledPose {
  BodyPose pose;
  /// Deepest point of the undressed skin below the floor [m], > 0 if there is one. Flesh gives way
  /// by so much.
  double sink_m = 0;
  /// Largest gap under a part that must lie on something: head, trunk, hands, feet [m].
  double float_m = 0;
  int evaluations = 0;
};

/// Lets a drawn pose sink onto the floor z = 0 until nothing can fall any farther.
///
/// Minimises the height of the masses of the body's parts under penalties for the floor, for parts
/// that run into each other (as capsules), for joint limits and for leaving the drawn pose, by a
/// pattern search over pelvis and joints. Deterministic; about 0.2 s.
SettledPose SettleOnFloor(const BodyRig& rig, const DrawnPose& drawn);

/// Settling is as good as it must be for a recording: at most 2 cm in, at most 3 cm of air below.
inline constexpr double kMaxSink = 0.02;
inline constexpr double kMaxFloat = 0.03;

/// Draws and settles until the result is good, and gives the best of the tries; none sinks in by
/// more than kMaxSink.
SettledPose DrawSettledPose(const BodyRig& rig, PoseFamily family, Random& random);

}  // namespace fallen::sim
