// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/simulate/body_pose.hpp"

namespace fallen::sim {

/// A part of the body as a capsule that moves with the bones: for its mass and its collisions.
struct BodyCapsule {
  std::string name;
  int bone_a = 0, bone_b = 0;    ///< that the two ends move with
  Eigen::Vector3d end_a, end_b;  ///< rest frame [m]
  double radius = 0;             ///< [m]
  double mass = 0;               ///< share of the body's mass
  bool must_rest = false;        ///< falls unless something holds it up
  bool leg = false;              ///< thigh, shank or foot
};

struct BodyCapsules {
  std::vector<BodyCapsule> capsules;
  std::vector<std::pair<int, int>> colliding;  ///< pairs that may meet; neighbours do not count
  /// Which capsule each bone's skin belongs to, by bone.
  std::vector<int> capsule_of_bone;

  /// The trunk has two capsules but one skin, which counts as the first one's.
  bool IsTrunk(int part) const;
  /// Parts on which this one can lie: those that it may collide with.
  std::set<int> MayRestOn(int part) const;
};

/// Measures the capsules of a body. Masses: [Winter09] Winter: Biomechanics and motor control of
/// human movement, 4th ed., table 4.1.
BodyCapsules MeasureCapsules(const HumanModel& model, const RestBody& body);

/// Smallest distance between two line segments.
double SegmentDistance(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                       const Eigen::Vector3d& b0, const Eigen::Vector3d& b1);

}  // namespace fallen::sim
