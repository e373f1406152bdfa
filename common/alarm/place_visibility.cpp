// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/place_visibility.hpp"

namespace fallen {
namespace {

// Five points along the box and three across, in shares of its half edges: within it, since the
// person does not fill its corners.
constexpr double kAlong[] = {-0.8, -0.4, 0, 0.4, 0.8};
constexpr double kAcross[] = {-0.6, 0, 0.6};

}  // namespace

std::optional<double> VisibleShare(const CameraView& view, const Eigen::Isometry3d& T_map_camera,
                                   const OrientedBox& box, double margin_m) {
  if (!view.is_known()) return std::nullopt;
  const Eigen::Isometry3d T_camera_map = T_map_camera.inverse();
  const Eigen::AngleAxisd turn(box.yaw, Eigen::Vector3d::UnitZ());
  int seen = 0;
  int points = 0;
  for (const double along : kAlong)
    for (const double across : kAcross) {
      const Eigen::Vector3d offset(along * box.size.x() / 2, across * box.size.y() / 2, 0);
      const Eigen::Vector3d p_camera = T_camera_map * (box.center + turn * offset);
      const std::optional<double> depth_m = view.DepthTowards(p_camera);
      ++points;
      if (depth_m && *depth_m + margin_m >= p_camera.z()) ++seen;
    }
  return static_cast<double>(seen) / points;
}

}  // namespace fallen
