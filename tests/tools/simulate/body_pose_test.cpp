// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/body_pose.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/body_capsules.hpp"
#include "tools/simulate/lying_poses.hpp"

namespace fallen::sim {
namespace {

class BodyPoseTest : public WithAssets {
 protected:
  void SetUp() override {
    WithAssets::SetUp();
    if (IsSkipped()) return;
    body_ = MakeRestBody(assets().humans, DrawBodyShape(2));
    rig_.emplace(assets().humans, body_);
  }
  Eigen::Vector3d Head(const BodyRig::BoneTransforms& transforms, const char* bone) const {
    const auto b = static_cast<std::size_t>(assets().humans.bone(bone));
    return transforms.rotations[b] * body_.bone_heads[b] + transforms.translations[b];
  }
  RestBody body_;
  std::optional<BodyRig> rig_;
};

TEST_F(BodyPoseTest, LimbsPointWhereTheyAreTold) {
  BodyPose pose;
  const Eigen::Vector3d up(0.3, 0.9, 0.1);
  pose.arms[kLeft].root = rig_->LimbRotation(Limb::kArm, kLeft, up, 0.4);
  pose.legs[kRight].root = rig_->LimbRotation(Limb::kLeg, kRight, {-0.1, -0.5, 0.8}, 0);
  BodyRig::BoneTransforms transforms;
  rig_->Transform(pose, transforms);
  const Eigen::Vector3d arm = Head(transforms, "lowerarm01.L") - Head(transforms, "upperarm01.L");
  EXPECT_GT(arm.normalized().dot(up.normalized()), 0.999);
  const Eigen::Vector3d leg = Head(transforms, "lowerleg01.R") - Head(transforms, "upperleg01.R");
  EXPECT_GT(leg.normalized().dot(Eigen::Vector3d(-0.1, -0.5, 0.8).normalized()), 0.999);
}

TEST_F(BodyPoseTest, HingesBendByTheirAngle) {
  for (const double angle : {0.0, 0.7, 2.0}) {
    BodyPose pose;
    for (const Side side : {kLeft, kRight}) pose.arms[side].hinge = pose.legs[side].hinge = angle;
    BodyRig::BoneTransforms transforms;
    rig_->Transform(pose, transforms);
    const auto bend = [&](const char* a, const char* b, const char* c) {
      const Eigen::Vector3d upper = Head(transforms, b) - Head(transforms, a);
      const Eigen::Vector3d lower = Head(transforms, c) - Head(transforms, b);
      return std::acos(std::min(1.0, upper.normalized().dot(lower.normalized())));
    };
    // The rest pose's bend lies within 5 degrees of the hinge's plane.
    EXPECT_NEAR(bend("upperarm01.L", "lowerarm01.L", "wrist.L"), angle, 0.12);
    EXPECT_NEAR(bend("upperleg01.R", "lowerleg01.R", "foot.R"), angle, 0.12);
  }
}

TEST_F(BodyPoseTest, BonesKeepTheirLength) {
  Random random(5);
  const DrawnPose drawn = DrawLyingPose(*rig_, PoseFamily::kSprawled, random);
  BodyRig::BoneTransforms transforms;
  rig_->Transform(drawn.pose, transforms);
  const HumanModel& model = assets().humans;
  for (std::size_t b = 0; b < model.bones.size(); ++b) {
    if (model.bones[b].parent < 0) continue;
    const auto p = static_cast<std::size_t>(model.bones[b].parent);
    const Eigen::Vector3d child =
        transforms.rotations[b] * body_.bone_heads[b] + transforms.translations[b];
    const Eigen::Vector3d parent =
        transforms.rotations[p] * body_.bone_heads[p] + transforms.translations[p];
    EXPECT_NEAR((child - parent).norm(), (body_.bone_heads[b] - body_.bone_heads[p]).norm(), 1e-9);
  }
}

TEST_F(BodyPoseTest, SkinFollowsRigidMotionExactly) {
  BodyPose pose;
  pose.orientation = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized());
  pose.position = {1, 2, 3};
  BodyRig::BoneTransforms moved;
  rig_->Transform(pose, moved);
  BodyPose rest;
  BodyRig::BoneTransforms unmoved;
  rig_->Transform(rest, unmoved);
  const Eigen::Matrix3Xf a = Skin(assets().humans, moved, body_.skin);
  const Eigen::Matrix3Xf b = Skin(assets().humans, unmoved, body_.skin);
  for (Eigen::Index v = 0; v < a.cols(); v += 97)
    EXPECT_NEAR((a.col(v) - a.col(0)).norm(), (b.col(v) - b.col(0)).norm(), 1e-5);
}

TEST(LyingOrientation, OnTheBackTheFaceIsUpOnTheLeftSideTheLeftIsDown) {
  const Eigen::Vector3d front(0, 0, 1), left(1, 0, 0), up(0, 1, 0);
  EXPECT_GT((LyingOrientation(0) * front).z(), 0.999);
  EXPECT_GT((LyingOrientation(0) * up).x(), 0.999);
  EXPECT_LT((LyingOrientation(M_PI / 2) * left).z(), -0.999);
  EXPECT_LT((LyingOrientation(M_PI) * front).z(), -0.999);
}

TEST(SegmentDistance, AgreesWithSampling) {
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const auto point = [&] {
      return Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal());
    };
    const Eigen::Vector3d a0 = point(), a1 = point(), b0 = point(), b1 = i % 5 == 0 ? b0 : point();
    double nearest = 1e9;
    for (double s = 0; s <= 1; s += 0.005)
      for (double t = 0; t <= 1; t += 0.005)
        nearest = std::min(nearest, (a0 + s * (a1 - a0) - b0 - t * (b1 - b0)).norm());
    EXPECT_NEAR(SegmentDistance(a0, a1, b0, b1), nearest, 0.02);
    EXPECT_LE(SegmentDistance(a0, a1, b0, b1), nearest + 1e-9);
  }
}

}  // namespace
}  // namespace fallen::sim
