// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fallen::sim {
namespace {

TEST(Scene, BoxAroundATurnedBoxIsTheBox) {
  const SceneObject object = PlaceObject("box", "b", MakeBox({1.8, 0.5, 0.3}), {1, 2, 0.15}, 0.7);
  EXPECT_TRUE(object.box.size.isApprox(Eigen::Vector3d(1.8, 0.5, 0.3), 1e-5));
  EXPECT_TRUE(object.box.center.isApprox(Eigen::Vector3d(1, 2, 0.15), 1e-5));
  EXPECT_DOUBLE_EQ(object.box.yaw, 0.7);
}

TEST(Scene, MainAxisIsTheLongOneUpToHalfATurn) {
  const SceneObject object = PlaceObject("box", "b", MakeBox({1.8, 0.5, 0.3}), {1, 2, 0}, 0.7);
  EXPECT_NEAR(std::remainder(MainAxisYaw(object.mesh) - 0.7, M_PI), 0, 1e-5);
}

TEST(Scene, BoxHoldsEveryVertex) {
  TriangleMesh mesh = MakeTube({{0, 0, 0.1}, {1, 0.3, 0.1}, {1.5, 1, 0.4}}, {0.1, 0.2, 0.1});
  OrientedBox box = BoxAround(mesh, MainAxisYaw(mesh));
  box.size.array() += 1e-5;  // [m], single precision
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    EXPECT_TRUE(box.Contains(vertex.cast<double>()));
}

}  // namespace
}  // namespace fallen::sim
