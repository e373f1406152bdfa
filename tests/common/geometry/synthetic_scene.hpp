// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "fallen/geometry/depth_image.hpp"

namespace fallen::testing {

inline constexpr double kRadPerDeg = 3.14159265358979323846 / 180;

/// A rectangle in the world (z up, floor at 0): `center` and two half edges at a right angle [m].
struct Rectangle {
  Eigen::Vector3d center;
  Eigen::Vector3d half_u;
  Eigen::Vector3d half_v;
};

inline Rectangle LevelRectangle(double x, double y, double z, double half_x, double half_y) {
  return {{x, y, z}, {half_x, 0, 0}, {0, half_y, 0}};
}

/// A wall across the view at the distance `x`.
inline Rectangle FrontWall(double x) { return {{x, 0, 1.5}, {0, 10, 0}, {0, 0, 1.5}}; }

/// A wall along the view, `y` to the left.
inline Rectangle SideWall(double y) { return {{0, y, 1.5}, {10, 0, 0}, {0, 0, 1.5}}; }

/// Floor as far as any sensor looks.
inline Rectangle Floor() { return LevelRectangle(0, 0, 0, 20, 20); }

/// Camera above the world's origin that looks along x: positive pitch is down, positive roll turns
/// the image's right down.
inline Eigen::Isometry3d CameraPose(double height_m, double pitch_deg, double roll_deg) {
  Eigen::Matrix3d level;  // columns: image right, image down, forward
  level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() = level *
                            Eigen::AngleAxisd(-pitch_deg * kRadPerDeg, Eigen::Vector3d::UnitX()) *
                            Eigen::AngleAxisd(roll_deg * kRadPerDeg, Eigen::Vector3d::UnitZ());
  T_world_camera.translation() = Eigen::Vector3d(0, 0, height_m);
  return T_world_camera;
}

struct Rendering {
  DepthImage image;
  /// Pixels that show each rectangle.
  std::vector<int> pixels;
};

/// Casts one ray a pixel, in range 0.4 to 5 m. With `noise`, disparity (f = 570, base 0.075 m) has
/// 0.15 pixel of Gaussian noise and steps of 1/8 pixel, and 5 % of the pixels are missing.
inline Rendering Render(const std::vector<Rectangle>& scene,
                        const Eigen::Isometry3d& T_world_camera, bool noise = true,
                        std::uint64_t seed = 1) {
  constexpr double kPixelsPerInverseMetre = 570 * 0.075;
  Rendering rendering;
  rendering.image.intrinsics = {640, 480, 570, 570, 319.5, 239.5};
  rendering.image.depth_unit_m = 0.001;
  rendering.image.depth.assign(640 * 480, 0);
  rendering.pixels.assign(scene.size(), 0);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> disparity_noise(0, 0.15);
  std::bernoulli_distribution dropped(0.05);
  const Eigen::Vector3d origin = T_world_camera.translation();
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const Eigen::Vector3d ray =
          T_world_camera.linear() * rendering.image.intrinsics.Deproject(u, v, 1);
      double z = std::numeric_limits<double>::infinity();
      std::size_t hit = 0;
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const Rectangle& r = scene[i];
        const Eigen::Vector3d normal = r.half_u.cross(r.half_v);
        const double t = normal.dot(r.center - origin) / normal.dot(ray);
        const Eigen::Vector3d p = origin + t * ray - r.center;
        if (t > 0 && t < z && std::abs(p.dot(r.half_u)) <= r.half_u.squaredNorm() &&
            std::abs(p.dot(r.half_v)) <= r.half_v.squaredNorm()) {
          z = t;
          hit = i;
        }
      }
      if (z < 0.4 || z > 5) continue;
      ++rendering.pixels[hit];
      if (noise) {
        if (dropped(random)) continue;
        const double disparity = kPixelsPerInverseMetre / z + disparity_noise(random);
        z = kPixelsPerInverseMetre / (std::round(8 * disparity) / 8);
      }
      rendering.image.depth[static_cast<std::size_t>(v * 640 + u)] =
          static_cast<std::uint16_t>(std::lround(1000 * z));
    }
  }
  return rendering;
}

}  // namespace fallen::testing
