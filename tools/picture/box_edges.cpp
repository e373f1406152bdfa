// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/box_edges.hpp"

#include <Eigen/Geometry>

namespace fallen {

std::array<Eigen::Vector3d, 8> BoxCorners(const OrientedBox& box) {
  const Eigen::AngleAxisd turn(box.yaw, Eigen::Vector3d::UnitZ());
  std::array<Eigen::Vector3d, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d side((i & 1) ? 0.5 : -0.5, (i & 2) ? 0.5 : -0.5, (i & 4) ? 0.5 : -0.5);
    corners[i] = box.center + turn * side.cwiseProduct(box.size);
  }
  return corners;
}

std::array<std::pair<int, int>, 12> BoxEdges() {
  std::array<std::pair<int, int>, 12> edges;
  std::size_t count = 0;
  for (int corner = 0; corner < 8; ++corner)
    for (const int axis : {1, 2, 4})
      if ((corner & axis) == 0) edges[count++] = {corner, corner | axis};
  return edges;
}

}  // namespace fallen
