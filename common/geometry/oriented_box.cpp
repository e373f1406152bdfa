// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/oriented_box.hpp"

#include <cmath>

namespace fallen {

bool OrientedBox::Contains(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d from_center = p - center;
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  const double along_x = c * from_center.x() + s * from_center.y();
  const double along_y = -s * from_center.x() + c * from_center.y();
  return std::abs(along_x) <= size.x() / 2 && std::abs(along_y) <= size.y() / 2 &&
         std::abs(from_center.z()) <= size.z() / 2;
}

}  // namespace fallen
