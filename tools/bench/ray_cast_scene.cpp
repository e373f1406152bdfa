// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bench/ray_cast_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fallen {
namespace {

constexpr double kFocalLengthAt640 = 575;
constexpr double kBaseline_m = 0.075;
constexpr double kDisparityStepsPerPixel = 8;

void KeepNearer(std::optional<double>& nearest, double t) {
  if (t > 0 && (!nearest || t < *nearest)) nearest = t;
}

void IntersectBox(const SceneBox& box, const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction, std::optional<double>& nearest) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int k = 0; k < 3; ++k) {
    const double t1 = (box.low[k] - origin[k]) / direction[k];
    const double t2 = (box.high[k] - origin[k]) / direction[k];
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  if (enter > leave) return;
  KeepNearer(nearest, enter > 0 ? enter : leave);
}

void IntersectEllipsoid(const SceneEllipsoid& ellipsoid, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction, std::optional<double>& nearest) {
  const Eigen::Vector3d o = ellipsoid.to_unit_sphere * (origin - ellipsoid.center);
  const Eigen::Vector3d d = ellipsoid.to_unit_sphere * direction;
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return;
  KeepNearer(nearest, (-b - std::sqrt(discriminant)) / a);
}

double NoisyDepth(double z_m, double focal_length, std::normal_distribution<double>& gaussian,
                  std::mt19937& generator) {
  const double beyond = z_m - 0.4;
  const double sigma = 0.0012 + 0.0019 * beyond * beyond;
  const double noisy = z_m + sigma * gaussian(generator);
  const double disparity = focal_length * kBaseline_m / std::max(noisy, 0.1);
  const double steps = std::round(disparity * kDisparityStepsPerPixel);
  return focal_length * kBaseline_m * kDisparityStepsPerPixel / steps;
}

}  // namespace

std::optional<double> RayCastScene::Intersect(const Eigen::Vector3d& origin,
                                              const Eigen::Vector3d& direction) const {
  std::optional<double> nearest;
  if (has_floor && direction.z() != 0) KeepNearer(nearest, -origin.z() / direction.z());
  for (const SceneBox& box : boxes) IntersectBox(box, origin, direction, nearest);
  for (const SceneEllipsoid& ellipsoid : ellipsoids)
    IntersectEllipsoid(ellipsoid, origin, direction, nearest);
  return nearest;
}

DepthImage RenderDepth(const RayCastScene& scene, const CameraIntrinsics& intrinsics,
                       const Eigen::Isometry3d& T_world_camera) {
  DepthImage image;
  image.intrinsics = intrinsics;
  image.depth_unit_m = 0.001;
  image.depth.assign(static_cast<std::size_t>(intrinsics.width) * intrinsics.height, 0);
  for (int v = 0; v < intrinsics.height; ++v)
    for (int u = 0; u < intrinsics.width; ++u) {
      const Eigen::Vector3d direction = T_world_camera.linear() * intrinsics.Deproject(u, v, 1);
      const auto z_m = scene.Intersect(T_world_camera.translation(), direction);
      if (!z_m || *z_m > 10) continue;
      image.depth[static_cast<std::size_t>(v) * intrinsics.width + u] =
          static_cast<std::uint16_t>(std::lround(*z_m / image.depth_unit_m));
    }
  return image;
}

DepthImage WithSensorNoise(DepthImage image, std::mt19937& generator) {
  std::normal_distribution<double> gaussian;
  for (std::uint16_t& depth : image.depth) {
    if (depth == 0) continue;
    const double z_m =
        NoisyDepth(depth * image.depth_unit_m, image.intrinsics.fx, gaussian, generator);
    depth = static_cast<std::uint16_t>(std::lround(z_m / image.depth_unit_m));
  }
  return image;
}

CameraIntrinsics PrimeSenseIntrinsics(int width, int height) {
  const double focal_length = kFocalLengthAt640 * width / 640;
  return {width, height, focal_length, focal_length, (width - 1) / 2.0, (height - 1) / 2.0};
}

Eigen::Isometry3d LookingDown(const Eigen::Vector3d& position, double yaw_rad, double pitch_rad) {
  Eigen::Matrix3d R_level_camera;  // optical axes in a frame with x ahead, z up
  R_level_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.translation() = position;
  T_world_camera.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                            Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) * R_level_camera;
  return T_world_camera;
}

std::vector<SceneEllipsoid> LyingPerson(const Eigen::Vector3d& center, double yaw_rad) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto part = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& radii) {
    return SceneEllipsoid{center + turn * at, radii.cwiseInverse().asDiagonal() * turn.transpose()};
  };
  return {part({0.75, 0.00, 0.11}, {0.12, 0.09, 0.11}),  // head
          part({0.25, 0.00, 0.13}, {0.38, 0.19, 0.13}),  // trunk
          part({0.20, 0.28, 0.06}, {0.33, 0.06, 0.06}),  // arms
          part({0.20, -0.28, 0.06}, {0.33, 0.06, 0.06}),
          part({-0.45, 0.11, 0.08}, {0.48, 0.09, 0.08}),  // legs
          part({-0.45, -0.11, 0.08}, {0.48, 0.09, 0.08})};
}

RayCastScene FurnishedRoom() {
  RayCastScene scene;
  scene.boxes = {
      {{4.4, -3.0, 0.0}, {4.5, 3.0, 2.5}},  // walls
      {{-1.0, 2.4, 0.0}, {4.5, 2.5, 2.5}},     {{-1.0, -2.5, 0.0}, {4.5, -2.4, 2.5}},
      {{2.6, 0.9, 0.70}, {3.8, 1.7, 0.74}},  // table: top and legs
      {{2.6, 0.9, 0.0}, {2.66, 0.96, 0.70}},   {{3.74, 0.9, 0.0}, {3.8, 0.96, 0.70}},
      {{2.6, 1.64, 0.0}, {2.66, 1.7, 0.70}},   {{3.74, 1.64, 0.0}, {3.8, 1.7, 0.70}},
      {{2.2, -2.4, 0.0}, {4.0, -1.5, 0.42}},  // sofa: seat and back
      {{2.2, -2.4, 0.42}, {4.0, -2.15, 0.85}}, {{4.0, 0.0, 0.0}, {4.4, 0.8, 1.8}}};  // cupboard
  return scene;
}

}  // namespace fallen
