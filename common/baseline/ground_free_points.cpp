// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/ground_free_points.hpp"

#include "fallen/geometry/ground_plane.hpp"

namespace fallen {

std::vector<Eigen::Vector3f> GroundFreePoints(const DepthImage& image, const Plane& ground_camera,
                                              const BaselineConfig& config) {
  image.Validate();
  const CameraIntrinsics& camera = image.intrinsics;
  const Eigen::Isometry3f T_level_camera = LevelFrameFromGround(ground_camera).cast<float>();
  const auto unit_m = static_cast<float>(image.depth_unit_m);
  std::vector<Eigen::Vector3f> points;
  std::size_t pixel = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const float depth_m = static_cast<float>(image.depth[pixel++]) * unit_m;
      if (depth_m <= 0 || depth_m > config.max_range_m) continue;
      const Eigen::Vector3f p = T_level_camera * camera.Deproject(u, v, depth_m).cast<float>();
      const double clearance_m =
          config.ground_clearance_m + config.ground_clearance_per_sq_m * depth_m * depth_m;
      if (p.z() >= clearance_m && p.z() <= config.max_height_m) points.push_back(p);
    }
  return points;
}

}  // namespace fallen
