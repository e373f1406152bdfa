// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/column_grid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fallen::sim {

ColumnGrid::ColumnGrid(const Eigen::Vector2d& room_size)
    : half_size_(room_size / 2),
      width_(static_cast<int>(std::ceil(room_size.x() / kCell))),
      height_(static_cast<int>(std::ceil(room_size.y() / kCell))),
      columns_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

int ColumnGrid::Index(double x, double y) const {
  const int column = static_cast<int>(std::floor((x + half_size_.x()) / kCell));
  const int row = static_cast<int>(std::floor((y + half_size_.y()) / kCell));
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return -1;
  return row * width_ + column;
}

void ColumnGrid::Add(const TriangleMesh& mesh) {
  // Points on every triangle, closer together than the columns.
  constexpr double kSpacing = kCell / 2;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[triangle[0]].cast<double>();
    const Eigen::Vector3d ab = mesh.vertices[triangle[1]].cast<double>() - a;
    const Eigen::Vector3d ac = mesh.vertices[triangle[2]].cast<double>() - a;
    // Steep triangles need points where they are long in the horizontal only, and at their ends.
    const double longest =
        std::max({ab.head<2>().norm(), ac.head<2>().norm(), (ac - ab).head<2>().norm()});
    const int steps = std::max(1, static_cast<int>(std::ceil(longest / kSpacing)));
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const Eigen::Vector3d p = a + ab * i / steps + ac * j / steps;
        const int index = Index(p.x(), p.y());
        if (index < 0) continue;
        Column& column = columns_[static_cast<std::size_t>(index)];
        column.low = std::min(column.low, static_cast<float>(p.z()));
        column.high = std::max(column.high, static_cast<float>(p.z()));
      }
    }
  }
}

bool ColumnGrid::Taken(const Eigen::Vector3d& p) const {
  const int index = Index(p.x(), p.y());
  if (index < 0) return true;
  const Column& column = columns_[static_cast<std::size_t>(index)];
  return p.z() > column.low && p.z() < column.high;
}

bool ColumnGrid::Blocked(double x, double y, double low, double high) const {
  const int index = Index(x, y);
  if (index < 0) return true;
  const Column& column = columns_[static_cast<std::size_t>(index)];
  return column.low < high && column.high > low;
}

bool ColumnGrid::Covered(const Eigen::Vector3d& p) const {
  const int index = Index(p.x(), p.y());
  if (index < 0) return false;
  const Column& column = columns_[static_cast<std::size_t>(index)];
  return column.low > p.z() && column.high >= column.low;
}

}  // namespace fallen::sim
