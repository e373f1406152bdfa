// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

double Area(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area +=
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
  return area;
}

TEST(TriangleMesh, BoxHasTheBoxesAreaAndBounds) {
  const TriangleMesh box = MakeBox({1, 2, 3});
  EXPECT_NEAR(Area(box), 2 * (2 + 6 + 3), 1e-5);
  EXPECT_TRUE(box.Bounds().sizes().isApprox(Eigen::Vector3f(1, 2, 3)));
  EXPECT_EQ(box.albedo.size(), box.triangles.size());
}

TEST(TriangleMesh, SuperellipsoidWithExponentsOneIsASphere) {
  const TriangleMesh sphere = MakeSuperellipsoid({2, 2, 2}, 1, 1);
  for (const Eigen::Vector3f& vertex : sphere.vertices) EXPECT_NEAR(vertex.norm(), 1, 1e-5);
  EXPECT_NEAR(Area(sphere), 4 * std::numbers::pi, 0.02 * 4 * std::numbers::pi);  // facets
}

TEST(TriangleMesh, TubeKeepsItsRadiusFromItsLine) {
  const TriangleMesh tube = MakeTube({{0, 0, 0}, {1, 0, 0}}, {0.1, 0.1});
  for (const Eigen::Vector3f& vertex : tube.vertices) {
    const float along = std::clamp(vertex.x(), 0.0f, 1.0f);
    EXPECT_NEAR((vertex - Eigen::Vector3f(along, 0, 0)).norm(), 0.1, 1e-5);
  }
  EXPECT_NEAR(tube.Bounds().sizes().x(), 1.2, 1e-5);
}

TEST(TriangleMesh, AppendKeepsTrianglesOnTheirVertices) {
  TriangleMesh mesh = MakeBox({1, 1, 1});
  TriangleMesh other = MakeBox({2, 2, 2});
  other.Transform(Eigen::Affine3f(Eigen::Translation3f(10, 0, 0)));
  mesh.Append(other);
  EXPECT_NEAR(Area(mesh), 6 + 24, 1e-4);
  EXPECT_FLOAT_EQ(mesh.Bounds().max().x(), 11);
}

}  // namespace
}  // namespace fallen::sim
