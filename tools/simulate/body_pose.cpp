// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/body_pose.hpp"

#include <cmath>

namespace fallen::sim {
namespace {

constexpr const char* kSuffix[2] = {".L", ".R"};

Eigen::Quaterniond FromRotationVector(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

// Elbows bend forward, knees backward: the axis about which a positive angle bends the joint.
Eigen::Vector3d HingeAxis(const Eigen::Vector3d& upper, const Eigen::Vector3d& bend_towards) {
  return upper.cross(bend_towards).normalized();
}

}  // namespace

BodyRig::BodyRig(const HumanModel& model, const RestBody& body) : model_(model), body_(body) {
  const auto head = [&](int bone) { return body.bone_heads[static_cast<std::size_t>(bone)]; };
  for (const Side side : {kLeft, kRight}) {
    const std::string suffix = kSuffix[side];
    const auto bone = [&](const char* name) { return model.bone(name + suffix); };
    // Raising an arm moves shoulder blade and collar bone as well.
    LimbBones& arm = arms_[side];
    arm.root = {bone("clavicle"), bone("shoulder01"), bone("upperarm01")};
    arm.root_share = {0.15, 0.15, 0.7};
    arm.hinge = bone("lowerarm01");
    arm.tip = bone("wrist");
    LimbBones& leg = legs_[side];
    leg.root = {-1, -1, bone("upperleg01")};
    leg.root_share = {0, 0, 1};
    leg.hinge = bone("lowerleg01");
    leg.tip = bone("foot");
    for (LimbBones* limb : {&arm, &leg}) {
      const Eigen::Vector3d upper = (head(limb->hinge) - head(limb->root[2])).normalized();
      const Eigen::Vector3d lower = (head(limb->tip) - head(limb->hinge)).normalized();
      const double forward = limb == &arm ? 1 : -1;
      limb->rest_direction = upper;
      limb->hinge_axis = HingeAxis(upper, Eigen::Vector3d(0, 0, forward));
      limb->rest_hinge = std::atan2(upper.cross(lower).dot(limb->hinge_axis), upper.dot(lower));
    }
  }
  spine_ = {model.bone("spine04"), model.bone("spine03"), model.bone("spine02"),
            model.bone("spine01")};
  neck_ = {model.bone("neck01"), model.bone("neck02"), model.bone("neck03"), model.bone("head")};
}

Eigen::Quaterniond BodyRig::LimbRotation(Limb limb, Side side, const Eigen::Vector3d& direction,
                                         double twist_rad) const {
  const LimbBones& bones = limb == Limb::kArm ? arms_[side] : legs_[side];
  const Eigen::Vector3d target = direction.normalized();
  const double mirrored = side == kLeft ? twist_rad : -twist_rad;
  return Eigen::AngleAxisd(mirrored, target) *
         Eigen::Quaterniond::FromTwoVectors(bones.rest_direction, target);
}

void BodyRig::Transform(const BodyPose& pose, BoneTransforms& transforms) const {
  const std::size_t count = model_.bones.size();
  thread_local std::vector<Eigen::Quaterniond> local;
  local.assign(count, Eigen::Quaterniond::Identity());
  const auto at = [](int bone) { return static_cast<std::size_t>(bone); };
  local[0] = pose.orientation;
  for (const int bone : spine_) local[at(bone)] = FromRotationVector(pose.spine / spine_.size());
  for (const int bone : neck_) local[at(bone)] = FromRotationVector(pose.neck / neck_.size());
  const auto set_limb = [&](const LimbBones& bones, const LimbPose& limb) {
    const Eigen::AngleAxisd root(limb.root);
    for (std::size_t i = 0; i < bones.root.size(); ++i)
      if (bones.root[i] >= 0)
        local[at(bones.root[i])] =
            Eigen::AngleAxisd(root.angle() * bones.root_share[i], root.axis());
    local[at(bones.hinge)] = Eigen::AngleAxisd(limb.hinge - bones.rest_hinge, bones.hinge_axis);
    local[at(bones.tip)] = Eigen::AngleAxisd(limb.tip, bones.hinge_axis);
  };
  for (const Side side : {kLeft, kRight}) {
    set_limb(arms_[side], pose.arms[side]);
    set_limb(legs_[side], pose.legs[side]);
  }
  transforms.rotations.resize(count);
  transforms.translations.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    const Eigen::Vector3d& head = body_.bone_heads[b];
    const int parent = model_.bones[b].parent;
    if (parent < 0) {
      transforms.rotations[b] = local[b].toRotationMatrix();
      transforms.translations[b] = pose.position - transforms.rotations[b] * head;
      continue;
    }
    const Eigen::Matrix3d& R_parent = transforms.rotations[at(parent)];
    const Eigen::Vector3d joint = R_parent * head + transforms.translations[at(parent)];
    transforms.rotations[b] = R_parent * local[b].toRotationMatrix();
    transforms.translations[b] = joint - transforms.rotations[b] * head;
  }
}

Eigen::Matrix3Xf Skin(const HumanModel& model, const BodyRig::BoneTransforms& transforms,
                      const Eigen::Matrix3Xf& rest) {
  Eigen::Matrix3Xf skinned(3, rest.cols());
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    const Eigen::Vector3d p = rest.col(v).cast<double>();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < kInfluencesPerVertex; ++k) {
      const auto bone = static_cast<std::size_t>(model.skin_bones[v][k]);
      const double weight = model.skin_weights[v][k];
      if (weight > 0)
        sum += weight * (transforms.rotations[bone] * p + transforms.translations[bone]);
    }
    skinned.col(v) = sum.cast<float>();
  }
  return skinned;
}

}  // namespace fallen::sim
