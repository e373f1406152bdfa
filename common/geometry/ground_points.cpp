// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fallen {
namespace {

// Half the base line of the local plane, as the tangent of an angle: 12 pixels of a VGA sensor.
// Disparity noise of 1/8 pixel then turns the normal of a floor 1 m below by 6 degrees.
constexpr double kHalfBaseLine = 0.02;
// Inverse depth bends by more than this only where the surface does: seven steps of 1/8 pixel of
// disparity at a base of 0.075 m and f = 575 pixels [1/m].
constexpr float kMaxBend = 0.02F;

// Inverse depths of the image [1/m], 0 where there is no measurement.
class InverseDepth {
 public:
  explicit InverseDepth(const DepthImage& image)
      : image_(image), units_per_m_(static_cast<float>(1 / image.depth_unit_m)) {}

  float operator()(int u, int v) const {
    if (u < 0 || v < 0 || u >= image_.intrinsics.width || v >= image_.intrinsics.height) return 0;
    const std::uint16_t depth =
        image_.depth[static_cast<std::size_t>(v) * image_.intrinsics.width + u];
    return depth == 0 ? 0 : units_per_m_ / static_cast<float>(depth);
  }

 private:
  const DepthImage& image_;
  float units_per_m_;
};

// Slope per pixel from the values `step` pixels before and after; one of them may be missing (0).
// False if both are, or if the three do not lie on a line.
bool SlopeFromNeighbors(float before, float center, float after, int step, float* slope) {
  const float pixels = static_cast<float>(step);
  if (before > 0 && after > 0) {
    *slope = (after - before) / (2 * pixels);
    return std::abs(before + after - 2 * center) <= kMaxBend;
  }
  if (after > 0) *slope = (after - center) / pixels;
  if (before > 0) *slope = (center - before) / pixels;
  return before > 0 || after > 0;
}

}  // namespace

std::vector<GroundPoint> SampleGroundPoints(const DepthImage& image, int sample_points) {
  const CameraIntrinsics& camera = image.intrinsics;
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const int stride = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / sample_points))));
  const int step_u = std::max(1, static_cast<int>(std::lround(kHalfBaseLine * camera.fx)));
  const int step_v = std::max(1, static_cast<int>(std::lround(kHalfBaseLine * camera.fy)));
  const float fx = static_cast<float>(camera.fx);
  const float fy = static_cast<float>(camera.fy);
  const InverseDepth inverse_depth(image);

  std::vector<GroundPoint> points;
  points.reserve(static_cast<std::size_t>(camera.width / stride + 1) *
                 static_cast<std::size_t>(camera.height / stride + 1));
  for (int v = stride / 2; v < camera.height; v += stride) {
    for (int u = stride / 2; u < camera.width; u += stride) {
      const float w = inverse_depth(u, v);
      if (w == 0) continue;
      GroundPoint& point = points.emplace_back();
      point.inverse_depth = w;
      point.ray = camera.Deproject(u, v, 1).cast<float>();
      point.position = point.ray / w;
      point.normal.setZero();
      float du = 0;
      float dv = 0;
      if (!SlopeFromNeighbors(inverse_depth(u - step_u, v), w, inverse_depth(u + step_u, v), step_u,
                              &du) ||
          !SlopeFromNeighbors(inverse_depth(u, v - step_v), w, inverse_depth(u, v + step_v), step_v,
                              &dv))
        continue;
      const float a = du * fx;
      const float b = dv * fy;
      const Eigen::Vector3f away(a, b, w - a * point.ray.x() - b * point.ray.y());
      point.normal = -away.normalized();
    }
  }
  return points;
}

}  // namespace fallen
