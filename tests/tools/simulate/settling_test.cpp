// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/settling.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/persons.hpp"

namespace fallen::sim {
namespace {

using SettlingTest = WithAssets;

// Heights of the undressed skin, computed from the pose alone.
std::vector<double> SkinHeights(const HumanModel& model, const RestBody& body,
                                const BodyPose& pose) {
  BodyRig::BoneTransforms transforms;
  BodyRig(model, body).Transform(pose, transforms);
  const Eigen::Matrix3Xf skin = Skin(model, transforms, body.skin);
  std::vector<double> heights;
  for (const int v : body.body_vertices) heights.push_back(skin(2, v));
  return heights;
}

TEST_F(SettlingTest, NobodyFloatsAndNobodySinksIn) {
  int poses = 0, bad = 0;
  for (const int id : {5}) {
    const RestBody body = MakeRestBody(assets().humans, DrawBodyShape(id));
    const BodyRig rig(assets().humans, body);
    for (const auto& [family, name] : EnumNames(PoseFamily{})) {
      Random random(static_cast<std::uint64_t>(100 * id) + static_cast<std::uint64_t>(family));
      const SettledPose settled = DrawSettledPose(rig, family, random);
      const std::vector<double> heights = SkinHeights(assets().humans, body, settled.pose);
      const double lowest = *std::min_element(heights.begin(), heights.end());
      EXPECT_NEAR(settled.sink_m, -lowest, 1e-6) << name;
      EXPECT_LE(-lowest, kMaxSink + 1e-6) << name;
      // A body lies low: its skin's median is nearer to the floor than a bent knee.
      std::vector<double> sorted = heights;
      std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 2),
                       sorted.end());
      EXPECT_LT(sorted[sorted.size() / 2], 0.25) << name;
      bad += settled.float_m > kMaxFloat;
      ++poses;
    }
  }
  EXPECT_LE(bad, poses / 15);
}

TEST_F(SettlingTest, AHandHeldUpFalls) {
  const RestBody body = MakeRestBody(assets().humans, DrawBodyShape(2));
  const BodyRig rig(assets().humans, body);
  Random random(1);
  DrawnPose drawn = DrawLyingPose(rig, PoseFamily::kSupine, random);
  drawn.pose.arms[kLeft].root = rig.LimbRotation(Limb::kArm, kLeft, {1, 0, 1.5}, 0);
  const SettledPose settled = SettleOnFloor(rig, drawn);
  EXPECT_LT(settled.float_m, 0.05);
}

TEST_F(SettlingTest, IsDeterministic) {
  const RestBody body = MakeRestBody(assets().humans, DrawBodyShape(2));
  const BodyRig rig(assets().humans, body);
  Random a(1), b(1);
  const SettledPose first = SettleOnFloor(rig, DrawLyingPose(rig, PoseFamily::kProne, a));
  const SettledPose second = SettleOnFloor(rig, DrawLyingPose(rig, PoseFamily::kProne, b));
  EXPECT_EQ(first.pose.position, second.pose.position);
  EXPECT_EQ(first.float_m, second.float_m);
}

TEST_F(SettlingTest, ClothesDoNotReachThroughTheFloor) {
  Random random(4);
  const PersonMesh person =
      MakeLyingPerson(assets().humans, DrawBodyShape(9), PoseFamily::kSideLeft, random);
  EXPECT_GE(person.mesh.Bounds().min().z(), 0);
  EXPECT_LT(person.mesh.Bounds().min().z(), 0.005);
}

TEST_F(SettlingTest, StandingPersonsAreAsTallAsTheyAre) {
  Random random(4);
  const BodyShape shape = DrawBodyShape(9);
  const double height = MakeStandingPerson(assets().humans, shape, random).Bounds().max().z();
  EXPECT_NEAR(height, shape.height_m, 0.15);  // [m]; they bend their knees and back a little
}

}  // namespace
}  // namespace fallen::sim
