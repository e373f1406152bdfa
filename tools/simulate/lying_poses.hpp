// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fallen/geometry/enum_names.hpp"
#include "tools/simulate/body_pose.hpp"
#include "tools/simulate/random.hpp"

/// How people lie on a floor, as drawn before gravity has its way.
///
/// Frame `lying`: z up, x from the pelvis towards the head, origin below the pelvis on the floor.
namespace fallen::sim {

enum class PoseFamily {
  kSupine,
  kSupineArmsSpread,
  kSupineArmsUp,
  kSupineKneeUp,
  kSupineHandOnBelly,
  kProne,
  kProneArmsUp,
  kProneCrawl,
  kSideLeft,
  kSideRight,
  kCurledLeft,
  kCurledRight,
  kRecoveryLeft,
  kRecoveryRight,
  kSprawled,
  kProneArmUnder,
  kCollapsedKneeling,  ///< knees drawn up below the trunk, the head on the floor
  kLegsOnChair,        ///< on the back, the lower legs laid up
  kFallenOver,         ///< beside what the feet stumbled over
  kHalfSitting,        ///< the back against a piece of furniture
};
constexpr auto EnumNames(PoseFamily) {
  return EnumTable<PoseFamily, 20>{{{PoseFamily::kSupine, "supine"},
                                    {PoseFamily::kSupineArmsSpread, "supine_arms_spread"},
                                    {PoseFamily::kSupineArmsUp, "supine_arms_up"},
                                    {PoseFamily::kSupineKneeUp, "supine_knee_up"},
                                    {PoseFamily::kSupineHandOnBelly, "supine_hand_on_belly"},
                                    {PoseFamily::kProne, "prone"},
                                    {PoseFamily::kProneArmsUp, "prone_arms_up"},
                                    {PoseFamily::kProneCrawl, "prone_crawl"},
                                    {PoseFamily::kSideLeft, "side_left"},
                                    {PoseFamily::kSideRight, "side_right"},
                                    {PoseFamily::kCurledLeft, "curled_left"},
                                    {PoseFamily::kCurledRight, "curled_right"},
                                    {PoseFamily::kRecoveryLeft, "recovery_left"},
                                    {PoseFamily::kRecoveryRight, "recovery_right"},
                                    {PoseFamily::kSprawled, "sprawled"},
                                    {PoseFamily::kProneArmUnder, "prone_arm_under"},
                                    {PoseFamily::kCollapsedKneeling, "collapsed_kneeling"},
                                    {PoseFamily::kLegsOnChair, "legs_on_chair"},
                                    {PoseFamily::kFallenOver, "fallen_over"},
                                    {PoseFamily::kHalfSitting, "half_sitting"}}};
}

/// How willingly a joint leaves its drawn angle for gravity's sake: standard deviation [rad].
struct PoseStiffness {
  double roll = 0.3;
  double spine = 0.4;
  double neck = 2.5;
  std::array<double, 2> arms = {5, 5};
  std::array<double, 2> legs = {1.5, 1.5};
};

struct DrawnPose {
  BodyPose pose;
  PoseStiffness stiffness;
  bool legs_held = false;   ///< by something that is not the floor
  bool trunk_held = false;  ///< by the thighs
};

/// Draws a pose of a family, with jitter in every joint. Somebody half sitting does not lie: see
/// MakeLyingPerson; here that is as supine.
DrawnPose DrawLyingPose(const BodyRig& rig, PoseFamily family, Random& random);

/// Rotation from the rest frame to `lying`: on the back for `roll` 0, on the left side for pi/2,
/// on the face for pi.
Eigen::Quaterniond LyingOrientation(double roll_rad);

}  // namespace fallen::sim
