// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ray_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fallen {
namespace {

// A ray that meets the Gaussian only where it is less likely than this says nothing about it; the
// value is that of the authors of [Saarinen13].
constexpr double kMinLikelihood = 0.3;
// Standard deviations by which a ray must end behind the Gaussian before it counts at all.
constexpr double kClearDeviations = 2;
// A ray stands for the light within half a pixel of it: the ray nearest to the mean meets even a
// Gaussian without thickness.
constexpr double kRayWidth_pixels = 0.5;
// The rays lie at a quarter of a cell around the one through the mean: about one standard deviation
// of points spread evenly over a cell.
constexpr double kRaySpread = 0.25;

// Nearer than any depth sensor measures: nothing can be said about voxels around the camera.
constexpr double kNearestDepth_m = 0.1;

struct Pixel {
  int u, v;
};

// exp(-x) for x >= 0, as (1 - x / 16)^16, at most 0.02 off: by multiplications only, so that every
// processor gives the same bits.
double FallingExponential(double x) {
  const double base = std::max(0.0, 1 - x / 16);
  const double power2 = base * base;
  const double power4 = power2 * power2;
  const double power8 = power4 * power4;
  return power8 * power8;
}

// Axial standard deviation of a PrimeSense-type sensor [Nguyen12].
double DepthNoise(double z_m) {
  const double beyond = z_m - 0.4;
  return 0.0012 + 0.0019 * beyond * beyond;
}

bool ProjectIntoImage(const CameraIntrinsics& camera, const Eigen::Vector3d& p, Pixel& pixel) {
  if (!(p.z() > kNearestDepth_m)) return false;
  const double u = camera.fx * p.x() / p.z() + camera.cx;
  const double v = camera.fy * p.y() / p.z() + camera.cy;
  // In this form a coordinate that is not finite is outside too.
  if (!(u >= -0.5 && v >= -0.5 && u < camera.width - 0.5 && v < camera.height - 0.5)) return false;
  pixel = {static_cast<int>(u + 0.5), static_cast<int>(v + 0.5)};
  return true;
}

double DepthAt(const DepthImage& image, const Pixel& pixel) {
  const CameraIntrinsics& camera = image.intrinsics;
  if (pixel.u < 0 || pixel.v < 0 || pixel.u >= camera.width || pixel.v >= camera.height) return 0;
  return image.depth[static_cast<std::size_t>(pixel.v) * camera.width + pixel.u] *
         image.depth_unit_m;
}

// Depth at which the ray of a pixel ended, 0 if unknown: the nearest of the pixel and its four
// neighbours. A sensor's depth is that of somewhere within a pixel, so beside an edge a single
// pixel may tell what is behind it.
double NearestEnd(const DepthImage& image, const Pixel& pixel) {
  double nearest_m = DepthAt(image, pixel);
  if (nearest_m <= 0) return 0;
  for (const Pixel& step : {Pixel{-1, 0}, Pixel{1, 0}, Pixel{0, -1}, Pixel{0, 1}}) {
    const double beside_m = DepthAt(image, {pixel.u + step.u, pixel.v + step.v});
    if (beside_m > 0) nearest_m = std::min(nearest_m, beside_m);
  }
  return nearest_m;
}

using RayPixels = std::array<Pixel, kRaysPerVoxel>;

// The pixels whose rays are looked up for a Gaussian; false if its mean is not in the image.
bool ChooseRays(const CameraIntrinsics& camera, const Eigen::Vector3d& mean, double cell_size_m,
                RayPixels& pixels) {
  Pixel center;
  if (!ProjectIntoImage(camera, mean, center)) return false;
  const int spread_u =
      std::max(1, static_cast<int>(kRaySpread * cell_size_m * camera.fx / mean.z()));
  const int spread_v =
      std::max(1, static_cast<int>(kRaySpread * cell_size_m * camera.fy / mean.z()));
  pixels = {{{center.u, center.v},
             {center.u - spread_u, center.v},
             {center.u + spread_u, center.v},
             {center.u, center.v - spread_v},
             {center.u, center.v + spread_v}}};
  return true;
}

bool AnyEndsBehind(const DepthImage& image, const RayPixels& pixels, double depth_m) {
  double farthest_m = 0;
  for (const Pixel& pixel : pixels) farthest_m = std::max(farthest_m, DepthAt(image, pixel));
  return farthest_m > depth_m;
}

SymmetricMatrix3 Inverse(const SymmetricMatrix3& m) {
  const double c0 = m[3] * m[5] - m[4] * m[4];
  const double c1 = m[2] * m[4] - m[1] * m[5];
  const double c2 = m[1] * m[4] - m[2] * m[3];
  const double scale = 1 / (m[0] * c0 + m[1] * c1 + m[2] * c2);
  return {c0 * scale,
          c1 * scale,
          c2 * scale,
          (m[0] * m[5] - m[2] * m[2]) * scale,
          (m[1] * m[2] - m[0] * m[4]) * scale,
          (m[0] * m[3] - m[1] * m[1]) * scale};
}

Eigen::Vector3d Multiply(const SymmetricMatrix3& m, const Eigen::Vector3d& v) {
  return {m[0] * v.x() + m[1] * v.y() + m[2] * v.z(), m[1] * v.x() + m[3] * v.y() + m[4] * v.z(),
          m[2] * v.x() + m[4] * v.y() + m[5] * v.z()};
}

SymmetricMatrix3 Widened(SymmetricMatrix3 covariance, double deviation_m) {
  for (const int k : {0, 3, 5}) covariance[k] += deviation_m * deviation_m;
  return covariance;
}

// A Gaussian as seen along rays from the origin of the camera frame.
class SeenGaussian {
 public:
  SeenGaussian(const Eigen::Vector3d& mean, const SymmetricMatrix3& covariance, double pixel_m)
      : mean_(mean),
        information_(Inverse(Widened(covariance, kRayWidth_pixels * pixel_m))),
        information_mean_(Multiply(information_, mean)),
        wide_information_(Inverse(Widened(covariance, pixel_m))) {}

  // Weight in [0, 1] of the ray along `ray` (z = 1) that ended at depth `end_m`.
  double WeightOfRay(const Eigen::Vector3d& ray, double end_m) const {
    const double along = ray.dot(Multiply(information_, ray));
    const double depth_m = ray.dot(information_mean_) / along;  // of the most likely point
    const double sq_depth_of_gaussian = 1 / ray.dot(Multiply(wide_information_, ray));
    const double deviation_m =
        std::sqrt(sq_depth_of_gaussian + DepthNoise(end_m) * DepthNoise(end_m));
    const double behind = (end_m - depth_m) / deviation_m - kClearDeviations;
    if (!(behind > 0)) return 0;
    const Eigen::Vector3d off = depth_m * ray - mean_;
    const double likelihood = FallingExponential(off.dot(Multiply(information_, off)) / 2);
    if (likelihood < kMinLikelihood) return 0;
    return likelihood * (1 - FallingExponential(behind * behind / 2));
  }

 private:
  Eigen::Vector3d mean_;
  SymmetricMatrix3 information_;
  Eigen::Vector3d information_mean_;
  SymmetricMatrix3 wide_information_;  // of the Gaussian widened by a pixel
};

}  // namespace

double CountRaysThrough(const DepthImage& image, const Eigen::Vector3d& mean,
                        const SymmetricMatrix3& covariance, double cell_size_m) {
  const CameraIntrinsics& camera = image.intrinsics;
  RayPixels pixels;
  if (!ChooseRays(camera, mean, cell_size_m, pixels) || !AnyEndsBehind(image, pixels, mean.z()))
    return 0;
  const SeenGaussian gaussian(mean, covariance, mean.z() / std::min(camera.fx, camera.fy));
  double rays = 0;
  for (const Pixel& pixel : pixels) {
    const double end_m = NearestEnd(image, pixel);
    if (end_m > 0) rays += gaussian.WeightOfRay(camera.Deproject(pixel.u, pixel.v, 1), end_m);
  }
  return rays;
}

bool AnyRayEndsBehind(const DepthImage& image, const Eigen::Vector3d& mean, double cell_size_m) {
  RayPixels pixels;
  return ChooseRays(image.intrinsics, mean, cell_size_m, pixels) &&
         AnyEndsBehind(image, pixels, mean.z());
}

bool RayPassesCenter(const DepthImage& image, const Eigen::Vector3d& center, double cell_size_m) {
  Pixel pixel;
  if (!ProjectIntoImage(image.intrinsics, center, pixel)) return false;
  const double end_m = DepthAt(image, pixel);
  return end_m > center.z() + cell_size_m + kClearDeviations * DepthNoise(end_m);
}

}  // namespace fallen
