// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/composition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/compose/sensor_noise.hpp"
#include "tools/compose/splat_rendering.hpp"

namespace fallen {
namespace {

constexpr double kFloorM = 0.06;         // what lies lower is floor
constexpr double kSurfaceNoiseM = 0.03;  // so much nearer may still be the same surface

/// True if the scene's pixel hides a point of the person at `z_m`.
bool Hides(const DepthImage& scene, const Eigen::Isometry3d& T_level_camera, int u, int v,
           double z_m) {
  const CameraIntrinsics& camera = scene.intrinsics;
  const std::uint16_t depth = scene.depth[static_cast<std::size_t>(v) * camera.width + u];
  const double scene_z_m = depth * scene.depth_unit_m;
  if (depth == 0 || scene_z_m > z_m - kSurfaceNoiseM) return false;
  return (T_level_camera * camera.Deproject(u, v, scene_z_m)).z() > kFloorM;
}

/// Rounds a depth as a sensor does that measures disparity.
double Quantise(double z_m, const CameraIntrinsics& camera, const CompositionConfig& config) {
  if (config.disparity_step_px <= 0) return z_m;
  constexpr double kWidth = 640;  // which the step is given for
  const double step =
      config.disparity_step_px / (camera.fx * kWidth / camera.width * config.baseline_m);
  return 1 / (std::max(1.0, std::round(1 / z_m / step)) * step);
}

double VisibleShare(const DepthImage& scene, const Eigen::Isometry3d& T_level_camera,
                    const PersonCloud& person, const Eigen::Isometry3d& T_camera_person) {
  const CameraIntrinsics& camera = scene.intrinsics;
  std::size_t visible = 0;
  for (const Splat& splat : person.splats) {
    const Eigen::Vector3d p = T_camera_person * splat.position;
    if (p.z() <= 0) continue;
    const Eigen::Vector2d pixel = camera.Project(p);
    const int u = static_cast<int>(std::lround(pixel.x()));
    const int v = static_cast<int>(std::lround(pixel.y()));
    if (u < 0 || v < 0 || u >= camera.width || v >= camera.height) continue;
    visible += !Hides(scene, T_level_camera, u, v, p.z());
  }
  return static_cast<double>(visible) / static_cast<double>(person.splats.size());
}

}  // namespace

Composition Compose(const DepthImage& scene, const Eigen::Isometry3d& T_level_camera,
                    const PersonCloud& person, const Eigen::Isometry3d& T_level_person,
                    const CompositionConfig& config) {
  const CameraIntrinsics& camera = scene.intrinsics;
  const Eigen::Isometry3d T_camera_person = T_level_camera.inverse() * T_level_person;
  const std::vector<double> depth_m =
      AddSensorNoise(RenderSplats(person.splats, camera, T_camera_person), camera,
                     config.noise_scale, config.noise_seed);
  Composition result{scene, std::vector<std::uint8_t>(scene.depth.size(), 0), 0};
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u, ++i) {
      if (depth_m[i] == 0 || Hides(scene, T_level_camera, u, v, depth_m[i])) continue;
      const double units = std::round(Quantise(depth_m[i], camera, config) / scene.depth_unit_m);
      if (units > std::numeric_limits<std::uint16_t>::max()) continue;
      result.image.depth[i] = static_cast<std::uint16_t>(units);
      result.is_person[i] = 1;
    }
  result.visible_share = VisibleShare(scene, T_level_camera, person, T_camera_person);
  return result;
}

}  // namespace fallen
