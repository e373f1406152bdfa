// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/lying_poses.hpp"

#include <numbers>

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;

// Draws limbs by where they point: out (away from the body's middle), up (towards the head), front.
class Drawer {
 public:
  Drawer(const BodyRig& rig, Random& random) : rig_(rig), random_(random) {
    for (const Side side : {kLeft, kRight}) {
      ArmAlong(side);
      LegStraight(side);
    }
    pose().spine = {random.Normal(0, 0.05), random.Normal(0, 0.06), random.Normal(0, 0.08)};
    pose().neck = {random.Normal(0, 0.1), random.Normal(0, 0.3), random.Normal(0, 0.1)};
  }

  BodyPose& pose() { return drawn_.pose; }
  PoseStiffness& stiffness() { return drawn_.stiffness; }
  void HoldTrunk() { drawn_.trunk_held = true; }
  void HoldLegs() {
    constexpr double kHeld = 0.02;  // [rad]
    drawn_.legs_held = true;
    drawn_.stiffness.legs = {kHeld, kHeld};
  }
  const DrawnPose& drawn() const { return drawn_; }
  double Between(double low, double high) { return random_.Uniform(low, high); }
  Side AnySide() { return random_.Chance(0.5) ? kLeft : kRight; }

  void Lie(double roll_rad) { pose().orientation = LyingOrientation(roll_rad); }

  void Arm(Side side, double out, double up, double front, double elbow, double twist) {
    LimbPose& arm = pose().arms[side];
    arm.root = rig_.LimbRotation(Limb::kArm, side, Direction(side, out, up, front), twist);
    arm.hinge = elbow;
    arm.tip = random_.Normal(0, 0.2);
  }
  void Leg(Side side, double out, double up, double front, double knee, double twist) {
    LimbPose& leg = pose().legs[side];
    leg.root = rig_.LimbRotation(Limb::kLeg, side, Direction(side, out, up, front), twist);
    leg.hinge = knee;
    leg.tip = Between(0.1, 0.6);  // a relaxed foot points
  }

  void ArmAlong(Side side) {
    Arm(side, Between(0.15, 0.5), -1, Between(-0.1, 0.2), Between(0.05, 0.6), Between(-0.8, 0.8));
  }
  void ArmSpread(Side side) {
    Arm(side, 1, Between(-0.5, 0.6), Between(-0.1, 0.1), Between(0.05, 1.2), Between(-1, 1));
  }
  void ArmUp(Side side) {
    Arm(side, Between(0.3, 0.8), 1, Between(-0.1, 0.2), Between(0.1, 1.4), Between(-1, 1));
  }
  void LegStraight(Side side) {
    Leg(side, Between(0.02, 0.3), -1, Between(-0.02, 0.1), Between(0, 0.25), -Between(0, 0.7));
  }
  void LegFlexed(Side side, double hip_low, double hip_high, double knee_low, double knee_high) {
    const double hip = Between(hip_low, hip_high);
    Leg(side, Between(0, 0.12), -std::cos(hip), std::sin(hip), Between(knee_low, knee_high),
        Between(-0.1, 0.1));
  }

 private:
  Eigen::Vector3d Direction(Side side, double out, double up, double front) {
    const double jitter = 0.06;
    return {(side == kLeft ? out : -out) + random_.Normal(0, jitter),
            up + random_.Normal(0, jitter), front + random_.Normal(0, jitter)};
  }

  const BodyRig& rig_;
  Random& random_;
  DrawnPose drawn_;
};

void DrawProneHead(Drawer& drawer) {
  const double turn = drawer.Between(0.8, 1.3);  // nobody rests on the nose
  drawer.pose().neck = {drawer.Between(-0.2, 0.1), drawer.AnySide() == kLeft ? turn : -turn, 0};
  for (LimbPose& leg : drawer.pose().legs) leg.tip = drawer.Between(0.5, 0.95);
}

// On the side, the upper leg and the head hang: only their weight holds them down.
void RelaxOnSide(Drawer& drawer) {
  drawer.stiffness().legs = {3, 3};
  drawer.stiffness().neck = 4;
}

void DrawSide(Drawer& drawer, Side below) {
  const Side above = below == kLeft ? kRight : kLeft;
  const double roll = drawer.Between(1.35, 1.85);
  drawer.Lie(below == kLeft ? roll : -roll);
  drawer.stiffness().roll = 0.12;
  drawer.Arm(below, drawer.Between(-0.1, 0.2), drawer.Between(-0.6, 0.9), 1,
             drawer.Between(0.1, 1.6), drawer.Between(-0.6, 0.6));
  drawer.Arm(above, drawer.Between(-0.2, 0.2), drawer.Between(-1, -0.2), drawer.Between(0.1, 0.9),
             drawer.Between(0.2, 1.3), drawer.Between(-0.5, 0.5));
  drawer.LegFlexed(below, 0, 0.5, 0.1, 0.7);
  drawer.LegFlexed(above, 0.1, 0.9, 0.2, 1.1);
  drawer.pose().neck.z() = 0;
  RelaxOnSide(drawer);
}

void DrawCurled(Drawer& drawer, Side below) {
  DrawSide(drawer, below);
  for (const Side side : {kLeft, kRight}) {
    drawer.LegFlexed(side, 1.1, 1.9, 1.4, 2.2);
    drawer.Arm(side, drawer.Between(-0.3, 0.1), drawer.Between(-0.5, 0.2), 1,
               drawer.Between(1.2, 2.2), drawer.Between(-0.4, 0.4));
  }
  drawer.pose().spine.x() = drawer.Between(0.3, 0.8);
  drawer.pose().neck.x() = drawer.Between(0.1, 0.5);
}

void DrawRecovery(Drawer& drawer, Side below) {
  const Side above = below == kLeft ? kRight : kLeft;
  const double roll = drawer.Between(1.8, 2.3);  // past the side, towards the face
  drawer.Lie(below == kLeft ? roll : -roll);
  drawer.stiffness().roll = 0.15;
  drawer.Arm(below, drawer.Between(0.5, 1), drawer.Between(-0.3, 0.4), drawer.Between(0, 0.4),
             drawer.Between(0.1, 1), drawer.Between(-0.5, 0.5));
  drawer.Arm(above, drawer.Between(0, 0.3), drawer.Between(0, 0.4), 1, drawer.Between(1.2, 2.1),
             drawer.Between(-0.3, 0.3));
  drawer.LegFlexed(below, 0, 0.2, 0.05, 0.4);
  drawer.LegFlexed(above, 1.0, 1.5, 1.2, 1.8);
  RelaxOnSide(drawer);
}

void DrawSprawled(Drawer& drawer) {
  const bool prone = drawer.Between(0, 1) < 0.5;
  drawer.Lie((prone ? kPi : 0) + drawer.Between(-0.35, 0.35));
  if (prone) DrawProneHead(drawer);
  for (const Side side : {kLeft, kRight}) {
    const double angle = drawer.Between(-1.3, 1.4);
    drawer.Arm(side, std::cos(angle), std::sin(angle), drawer.Between(-0.2, 0.2),
               drawer.Between(0, 1.9), drawer.Between(-1.2, 1.2));
    const double spread = drawer.Between(0, 0.9);
    drawer.Leg(side, std::sin(spread), -std::cos(spread), drawer.Between(0, 0.2),
               drawer.Between(0, 1.5), -drawer.Between(0.2, 1.3));
  }
}

}  // namespace

Eigen::Quaterniond LyingOrientation(double roll_rad) {
  Eigen::Matrix3d R_lying_rest;
  R_lying_rest << 0, 1, 0,  //
      -1, 0, 0,             //
      0, 0, 1;
  return Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()) * Eigen::Quaterniond(R_lying_rest);
}

DrawnPose DrawLyingPose(const BodyRig& rig, PoseFamily family, Random& random) {
  Drawer drawer(rig, random);
  const bool prone = family == PoseFamily::kProne || family == PoseFamily::kProneArmsUp ||
                     family == PoseFamily::kProneCrawl || family == PoseFamily::kProneArmUnder ||
                     family == PoseFamily::kCollapsedKneeling;
  drawer.Lie((prone ? kPi : 0) + drawer.Between(-0.2, 0.2));
  if (prone) DrawProneHead(drawer);
  const Side side = drawer.AnySide();
  switch (family) {
    case PoseFamily::kSupine:
    case PoseFamily::kProne:
    case PoseFamily::kHalfSitting:
      break;
    case PoseFamily::kSupineArmsSpread:
      for (const Side arm : {kLeft, kRight}) drawer.ArmSpread(arm);
      break;
    case PoseFamily::kSupineArmsUp:
    case PoseFamily::kProneArmsUp:
      drawer.ArmUp(side);
      if (drawer.Between(0, 1) < 0.6) drawer.ArmUp(side == kLeft ? kRight : kLeft);
      break;
    case PoseFamily::kSupineKneeUp:
      drawer.LegFlexed(side, 0.7, 1.0, 1.5, 2.0);
      drawer.stiffness().legs[side] = 0.25;
      break;
    case PoseFamily::kSupineHandOnBelly:
      drawer.Arm(side, drawer.Between(0.35, 0.6), -1, drawer.Between(0.1, 0.3),
                 drawer.Between(1.2, 1.7), drawer.Between(0.8, 1.3));
      drawer.stiffness().arms[side] = 0.4;
      break;
    case PoseFamily::kProneCrawl:
      drawer.Leg(side, drawer.Between(0.6, 1), -drawer.Between(0.1, 0.6), 0,
                 drawer.Between(0.9, 1.7), -drawer.Between(0.8, 1.5));
      drawer.ArmUp(side);
      break;
    case PoseFamily::kSideLeft:
      DrawSide(drawer, kLeft);
      break;
    case PoseFamily::kSideRight:
      DrawSide(drawer, kRight);
      break;
    case PoseFamily::kCurledLeft:
      DrawCurled(drawer, kLeft);
      break;
    case PoseFamily::kCurledRight:
      DrawCurled(drawer, kRight);
      break;
    case PoseFamily::kRecoveryLeft:
      DrawRecovery(drawer, kLeft);
      break;
    case PoseFamily::kRecoveryRight:
      DrawRecovery(drawer, kRight);
      break;
    case PoseFamily::kSprawled:
    case PoseFamily::kFallenOver:
      DrawSprawled(drawer);
      break;
    case PoseFamily::kProneArmUnder:
      drawer.Arm(side, drawer.Between(0.05, 0.25), -1, drawer.Between(0.3, 0.6),
                 drawer.Between(0.9, 1.8), drawer.Between(0.2, 0.8));
      drawer.stiffness().arms[side] = 0.5;
      break;
    case PoseFamily::kCollapsedKneeling:
      for (const Side leg : {kLeft, kRight}) {
        drawer.LegFlexed(leg, 1.5, 2.1, 1.9, 2.25);
        drawer.stiffness().legs[leg] = 0.3;
        if (drawer.Between(0, 1) < 0.5) drawer.ArmUp(leg);
      }
      drawer.pose().spine.x() = drawer.Between(0.2, 0.7);
      drawer.HoldTrunk();
      break;
    case PoseFamily::kLegsOnChair: {
      const double hip = drawer.Between(1.1, 1.6);
      for (const Side leg : {kLeft, kRight})
        drawer.LegFlexed(leg, hip - 0.08, hip + 0.08, hip - 0.1, hip + 0.1);
      drawer.HoldLegs();
      break;
    }
  }
  return drawer.drawn();
}

}  // namespace fallen::sim
