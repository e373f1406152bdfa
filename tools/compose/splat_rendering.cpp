// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/splat_rendering.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fallen {
namespace {

constexpr double kMinZM = 0.1;
constexpr double kReachSigmas = 2.5;       // a disc's end
constexpr double kFrontSigmas = 1.5;       // so near its middle a disc may be the foremost
constexpr double kSameSurfaceM = 0.06;     // farther behind the foremost disc is another surface
constexpr double kMinFacingCosine = 0.15;  // discs seen more from the side are left out
// Inside a surface the weights sum up to about 5.9, on a straight edge to half of it (both from the
// density that kSigmaPerSpacing implies): the outline is then 0.4 sigma outside the points.
constexpr double kMinWeight = 2;

/// Calls `visit(pixel index, z [m], squared distance from the disc's middle in sigmas)` for every
/// pixel whose ray meets the disc.
template <class Visit>
void ForEachPixel(const Splat& splat, const CameraIntrinsics& camera, Visit&& visit) {
  const Eigen::Vector3d& center = splat.position;
  if (center.z() < kMinZM) return;
  if (std::abs(splat.normal.dot(center)) < kMinFacingCosine * center.norm()) return;
  const Eigen::Vector2d pixel = camera.Project(center);
  const double reach_m = kReachSigmas * splat.sigma_m;
  const double reach_u = reach_m * camera.fx / center.z();
  const double reach_v = reach_m * camera.fy / center.z();
  const int first_u = std::max(0, static_cast<int>(std::ceil(pixel.x() - reach_u)));
  const int first_v = std::max(0, static_cast<int>(std::ceil(pixel.y() - reach_v)));
  const int last_u = std::min(camera.width - 1, static_cast<int>(std::floor(pixel.x() + reach_u)));
  const int last_v = std::min(camera.height - 1, static_cast<int>(std::floor(pixel.y() + reach_v)));
  const double plane = splat.normal.dot(center);
  for (int v = first_v; v <= last_v; ++v)
    for (int u = first_u; u <= last_u; ++u) {
      const Eigen::Vector3d ray = camera.Deproject(u, v, 1);
      const double z_m = plane / splat.normal.dot(ray);
      const double sq_sigmas = (z_m * ray - center).squaredNorm() / (splat.sigma_m * splat.sigma_m);
      if (z_m >= kMinZM && sq_sigmas <= kReachSigmas * kReachSigmas)
        visit(static_cast<std::size_t>(v) * camera.width + u, z_m, sq_sigmas);
    }
}

}  // namespace

std::vector<double> RenderSplats(std::span<const Splat> splats, const CameraIntrinsics& camera,
                                 const Eigen::Isometry3d& T_camera_splats) {
  std::vector<Splat> seen(splats.begin(), splats.end());
  for (Splat& splat : seen) {
    splat.position = T_camera_splats * splat.position;
    splat.normal = T_camera_splats.linear() * splat.normal;
  }
  const auto pixels = static_cast<std::size_t>(camera.width) * camera.height;
  std::vector<double> front_m(pixels, 0), weight(pixels, 0), depth_m(pixels, 0);
  for (const Splat& splat : seen)
    ForEachPixel(splat, camera, [&](std::size_t i, double z_m, double sq_sigmas) {
      if (sq_sigmas > kFrontSigmas * kFrontSigmas) return;
      if (front_m[i] == 0 || z_m < front_m[i]) front_m[i] = z_m;
    });
  for (const Splat& splat : seen)
    ForEachPixel(splat, camera, [&](std::size_t i, double z_m, double sq_sigmas) {
      if (front_m[i] == 0 || z_m > front_m[i] + kSameSurfaceM) return;
      const double w = std::exp(-0.5 * sq_sigmas);
      weight[i] += w;
      depth_m[i] += w * z_m;
    });
  for (std::size_t i = 0; i < pixels; ++i)
    depth_m[i] = weight[i] >= kMinWeight ? depth_m[i] / weight[i] : 0;
  return depth_m;
}

}  // namespace fallen
