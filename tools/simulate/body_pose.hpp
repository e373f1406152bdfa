// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "tools/simulate/body_shape.hpp"

namespace fallen::sim {

enum Side : int { kLeft = 0, kRight = 1 };

/// Pose of an arm or a leg, relative to the trunk.
struct LimbPose {
  /// Shoulder or hip: from the rest pose, about axes of the rest frame that follow the trunk.
  Eigen::Quaterniond root = Eigen::Quaterniond::Identity();
  double hinge = 0;  ///< elbow or knee [rad]: 0 straight, positive bends
  double tip = 0;    ///< wrist or ankle [rad], about the hinge's axis, from the rest pose
};

/// Pose of a whole body in as many numbers as lying on a floor needs.
struct BodyPose {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_world_rest of the pelvis
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< head of the root bone, world [m]
  Eigen::Vector3d spine = Eigen::Vector3d::Zero();  ///< rotation vector, shared by four vertebrae
  Eigen::Vector3d neck = Eigen::Vector3d::Zero();   ///< rotation vector, shared by neck and head
  std::array<LimbPose, 2> arms;
  std::array<LimbPose, 2> legs;
};

enum class Limb { kArm, kLeg };

/// Bones that a BodyPose moves, looked up once, with what of the rest pose the angles refer to.
class BodyRig {
 public:
  /// Keeps references: `model` and `body` must outlive the rig.
  BodyRig(const HumanModel& model, const RestBody& body);

  /// Rotation of an upper arm or thigh from its rest direction to `direction` (rest frame: x left,
  /// y up, z forward), then by `twist_rad` about itself; twists of left and right mirror each
  /// other.
  Eigen::Quaterniond LimbRotation(Limb limb, Side side, const Eigen::Vector3d& direction,
                                  double twist_rad) const;

  struct BoneTransforms {
    std::vector<Eigen::Matrix3d> rotations;     ///< R_world_rest of each bone
    std::vector<Eigen::Vector3d> translations;  ///< p_world = R p_rest + t
  };
  /// Forward kinematics.
  void Transform(const BodyPose& pose, BoneTransforms& transforms) const;

  const HumanModel& model() const { return model_; }
  const RestBody& body() const { return body_; }

 private:
  struct LimbBones {
    std::array<int, 3> root;  ///< bones that share the root rotation; -1 for none
    std::array<double, 3> root_share;
    int hinge, tip;
    Eigen::Vector3d rest_direction;  ///< of the upper arm or thigh
    Eigen::Vector3d hinge_axis;
    double rest_hinge;  ///< angle between the two parts in the rest pose
  };
  const HumanModel& model_;
  const RestBody& body_;
  std::array<LimbBones, 2> arms_, legs_;
  std::array<int, 4> spine_, neck_;
};

/// Linear blend skinning of `rest` vertices (all of the base mesh), world frame [m].
Eigen::Matrix3Xf Skin(const HumanModel& model, const BodyRig::BoneTransforms& transforms,
                      const Eigen::Matrix3Xf& rest);

}  // namespace fallen::sim
