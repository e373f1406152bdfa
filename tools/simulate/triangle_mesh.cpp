// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

constexpr int kRoundSegments = 20;  // around a tube: 18 degrees a facet, invisible at 5 cm cells

std::uint8_t AlbedoByte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

// Triangles of a grid of rings x columns vertices that is closed around its columns.
void StitchRings(int rings, int columns, TriangleMesh& mesh) {
  const auto index = [&](int ring, int column) {
    return static_cast<std::uint32_t>(ring * columns + column % columns);
  };
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t a = index(ring, column), b = index(ring, column + 1);
      const std::uint32_t c = index(ring + 1, column + 1), d = index(ring + 1, column);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
}

double SignedPower(double base, double exponent) {
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

}  // namespace

Eigen::AlignedBox3f TriangleMesh::Bounds() const {
  Eigen::AlignedBox3f bounds;
  for (const Eigen::Vector3f& vertex : vertices) bounds.extend(vertex);
  return bounds;
}

void TriangleMesh::Append(const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& triangle : other.triangles)
    triangles.push_back({triangle[0] + offset, triangle[1] + offset, triangle[2] + offset});
  albedo.insert(albedo.end(), other.albedo.begin(), other.albedo.end());
}

void TriangleMesh::Transform(const Eigen::Affine3f& T_target_source) {
  for (Eigen::Vector3f& vertex : vertices) vertex = T_target_source * vertex;
}

void TriangleMesh::SetAlbedo(double value) { albedo.assign(triangles.size(), AlbedoByte(value)); }

TriangleMesh MakeBox(const Eigen::Vector3d& size, double albedo) {
  TriangleMesh mesh;
  const Eigen::Vector3f half = (size / 2).cast<float>();
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back({(corner & 1) ? half.x() : -half.x(),
                             (corner & 2) ? half.y() : -half.y(),
                             (corner & 4) ? half.z() : -half.z()});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh.SetAlbedo(albedo);
  return mesh;
}

TriangleMesh MakeSuperellipsoid(const Eigen::Vector3d& size, double vertical, double horizontal,
                                double albedo) {
  constexpr int kRings = 17, kColumns = 2 * kRoundSegments;
  TriangleMesh mesh;
  for (int ring = 0; ring < kRings; ++ring) {
    const double latitude = std::numbers::pi * (static_cast<double>(ring) / (kRings - 1) - 0.5);
    const double radius = SignedPower(std::cos(latitude), vertical);
    const double z = SignedPower(std::sin(latitude), vertical);
    for (int column = 0; column < kColumns; ++column) {
      const double longitude = 2 * std::numbers::pi * column / kColumns;
      const Eigen::Vector3d p(radius * SignedPower(std::cos(longitude), horizontal),
                              radius * SignedPower(std::sin(longitude), horizontal), z);
      mesh.vertices.push_back((p.cwiseProduct(size) / 2).cast<float>());
    }
  }
  StitchRings(kRings, kColumns, mesh);
  mesh.SetAlbedo(albedo);
  return mesh;
}

TriangleMesh MakeTube(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radii,
                      double albedo) {
  constexpr int kCapRings = 4;
  TriangleMesh mesh;
  int rings = 0;
  const auto add_ring = [&](const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                            double radius) {
    const Eigen::Vector3d side = axis.unitOrthogonal();
    for (int column = 0; column < kRoundSegments; ++column) {
      const double angle = 2 * std::numbers::pi * column / kRoundSegments;
      mesh.vertices.push_back(
          (center + Eigen::AngleAxisd(angle, axis) * side * radius).cast<float>());
    }
    ++rings;
  };
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const Eigen::Vector3d axis =
        (points[std::min(i + 1, last)] - points[i == 0 ? 0 : i - 1]).normalized();
    for (int cap = 0; cap < kCapRings && i == 0; ++cap) {
      const double angle = std::numbers::pi / 2 * (1 - static_cast<double>(cap) / kCapRings);
      add_ring(points[i] - axis * radii[i] * std::sin(angle), axis, radii[i] * std::cos(angle));
    }
    add_ring(points[i], axis, radii[i]);
    for (int cap = 1; cap <= kCapRings && i == last; ++cap) {
      const double angle = std::numbers::pi / 2 * cap / kCapRings;
      add_ring(points[i] + axis * radii[i] * std::sin(angle), axis, radii[i] * std::cos(angle));
    }
  }
  StitchRings(rings, kRoundSegments, mesh);
  mesh.SetAlbedo(albedo);
  return mesh;
}

}  // namespace fallen::sim
