// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tools/simulate/triangle_mesh.hpp"

namespace fallen::sim {

/// What of a room's volume is taken, as one interval of height for each column of a grid.
///
/// Below a table top there is room, inside a sofa there is none.
class ColumnGrid {
 public:
  static constexpr double kCell = 0.025;  ///< [m]

  /// Covers the room and counts what is outside as taken.
  explicit ColumnGrid(const Eigen::Vector2d& room_size);

  void Add(const TriangleMesh& mesh);

  /// True if a point is inside something or outside the room.
  bool Taken(const Eigen::Vector3d& p) const;

  /// True if something reaches into [low, high] in the column at (x, y), or there is no room.
  bool Blocked(double x, double y, double low, double high) const;

  /// True if there is something above the point in its column.
  bool Covered(const Eigen::Vector3d& p) const;

 private:
  struct Column {
    float low = 1e9f;
    float high = -1e9f;
  };
  /// Number of the column at (x, y), or -1 outside the room.
  int Index(double x, double y) const;

  Eigen::Vector2d half_size_;
  int width_, height_;
  std::vector<Column> columns_;
};

}  // namespace fallen::sim
