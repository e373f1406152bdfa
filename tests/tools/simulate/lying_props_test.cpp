// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/lying_props.hpp"

#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/persons.hpp"

namespace fallen::sim {
namespace {

using LyingPropsTest = WithAssets;

TEST_F(LyingPropsTest, FamiliesComeWithWhatTheyNeed) {
  const std::pair<PoseFamily, const char*> kFamilies[] = {{PoseFamily::kLegsOnChair, "seat"},
                                                          {PoseFamily::kHalfSitting, "backrest"},
                                                          {PoseFamily::kFallenOver, "obstacle"}};
  for (const auto& [family, prop] : kFamilies) {
    Random random(3);
    const PersonMesh person = MakeLyingPerson(assets().humans, DrawBodyShape(4), family, random);
    ASSERT_EQ(person.props.size(), 1u) << prop;
    EXPECT_EQ(person.props[0].name, prop);
    const Eigen::AlignedBox3f bounds = person.props[0].mesh.Bounds();
    EXPECT_GE(bounds.min().z(), -0.001) << prop;
    EXPECT_LT(bounds.min().z(), 0.03) << prop;
    // It touches the person or nearly does.
    EXPECT_LT(bounds.exteriorDistance(person.mesh.Bounds()), 0.03) << prop;
  }
}

TEST_F(LyingPropsTest, RaisedLegsLieOnTheirSeat) {
  Random random(6);
  const PersonMesh person =
      MakeLyingPerson(assets().humans, DrawBodyShape(4), PoseFamily::kLegsOnChair, random);
  const double feet = person.mesh.Bounds().min().x();
  double lowest = 1;
  for (const Eigen::Vector3f& vertex : person.mesh.vertices)
    if (vertex.x() < feet + 0.3 && vertex.z() > 0.2) lowest = std::min<double>(lowest, vertex.z());
  EXPECT_LE(person.settled.sink_m, kMaxSink);
  EXPECT_LT(lowest, 0.6);
  EXPECT_GT(lowest, 0.25);
}

TEST_F(LyingPropsTest, HalfSittingIsOnTheFloorWithTheHeadHigh) {
  Random random(2);
  const PersonMesh person =
      MakeLyingPerson(assets().humans, DrawBodyShape(4), PoseFamily::kHalfSitting, random);
  const Eigen::AlignedBox3f bounds = person.mesh.Bounds();
  EXPECT_NEAR(bounds.min().z(), 0, 0.005);
  EXPECT_GT(bounds.max().z(), 0.45);
  EXPECT_LT(bounds.max().z(), 1.05);
}

TEST_F(LyingPropsTest, ABlanketLiesAboveTheLegsAndLeavesTheHead) {
  Random random(7);
  const PersonMesh person =
      MakeLyingPerson(assets().humans, DrawBodyShape(4), PoseFamily::kSupine, random);
  const TriangleMesh blanket = MakeBlanketOver(person.mesh, random);
  ASSERT_FALSE(blanket.empty());
  const Eigen::AlignedBox3f bounds = blanket.Bounds();
  EXPECT_LT(bounds.max().x(), 0.4);
  EXPECT_LT(bounds.min().x(), person.mesh.Bounds().min().x());
  int above = 0, legs = 0;
  for (const Eigen::Vector3f& vertex : person.mesh.vertices) {
    if (vertex.x() > -0.4) continue;
    ++legs;
    double nearest = 1e9, height = 0;
    for (const Eigen::Vector3f& cloth : blanket.vertices) {
      const double distance = (cloth - vertex).head<2>().norm();
      if (distance < nearest) {
        nearest = distance;
        height = cloth.z();
      }
    }
    above += height > vertex.z() - 0.02;
  }
  EXPECT_GT(above, 0.97 * legs);
}

}  // namespace
}  // namespace fallen::sim
