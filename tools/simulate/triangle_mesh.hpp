// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace fallen::sim {

/// A surface of triangles [m].
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Share of infrared light that each triangle sends back, in 1/255; as many as triangles.
  std::vector<std::uint8_t> albedo;

  bool empty() const { return triangles.empty(); }
  Eigen::AlignedBox3f Bounds() const;
  void Append(const TriangleMesh& other);
  void Transform(const Eigen::Affine3f& T_target_source);
  void SetAlbedo(double value);
};

/// Albedo of a surface of which nothing is known: matt paint, wood, cloth.
inline constexpr double kUsualAlbedo = 0.55;

/// Box with its middle at the origin.
TriangleMesh MakeBox(const Eigen::Vector3d& size, double albedo = kUsualAlbedo);

/// Superellipsoid with its middle at the origin: `vertical` and `horizontal` exponents near 0 give
/// a box with rounded edges, 1 an ellipsoid. Cushions, bags, rounded cases.
TriangleMesh MakeSuperellipsoid(const Eigen::Vector3d& size, double vertical, double horizontal,
                                double albedo = kUsualAlbedo);

/// Round tube along a line of points with a radius at each, closed by half spheres at the ends.
/// Needs at least two points.
TriangleMesh MakeTube(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radii,
                      double albedo = kUsualAlbedo);

}  // namespace fallen::sim
