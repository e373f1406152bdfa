// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/camera_view.hpp"

#include <algorithm>
#include <cmath>

namespace fallen {
namespace {

constexpr int kMaxColumns = 32;
// Samples along each side of a block: the median of 25 is steady enough for 0.3 m more or less.
constexpr int kSamplesPerSide = 5;

int DivideUp(int value, int divisor) { return (value + divisor - 1) / divisor; }

/// Median of the measured samples of a block [units]; 0 if fewer than half are measured.
std::uint16_t BlockMedian(const DepthImage& image, int first_u, int first_v, int block,
                          std::vector<std::uint16_t>& samples) {
  const int step = DivideUp(block, kSamplesPerSide);
  const int end_u = std::min(first_u + block, image.intrinsics.width);
  const int end_v = std::min(first_v + block, image.intrinsics.height);
  samples.clear();
  std::size_t looked_at = 0;
  for (int v = first_v + (step - 1) / 2; v < end_v; v += step)
    for (int u = first_u + (step - 1) / 2; u < end_u; u += step) {
      ++looked_at;
      const std::uint16_t depth =
          image.depth[static_cast<std::size_t>(v) * image.intrinsics.width + u];
      if (depth != 0) samples.push_back(depth);
    }
  if (samples.empty() || 2 * samples.size() < looked_at) return 0;
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  return *middle;
}

}  // namespace

std::optional<double> CameraView::DepthTowards(const Eigen::Vector3d& p_camera) const {
  if (!is_known() || !(p_camera.z() > 0)) return std::nullopt;
  const Eigen::Vector2d block = intrinsics.Project(p_camera);
  const double column = std::floor(block.x() + 0.5);
  const double row = std::floor(block.y() + 0.5);
  if (!(column >= 0 && column < intrinsics.width && row >= 0 && row < intrinsics.height))
    return std::nullopt;
  const auto index =
      static_cast<std::size_t>(row) * intrinsics.width + static_cast<std::size_t>(column);
  if (depth_mm[index] == 0) return std::nullopt;
  return 1e-3 * depth_mm[index];
}

CameraView MakeCameraView(const DepthImage& image) {
  image.Validate();
  const CameraIntrinsics& pixels = image.intrinsics;
  const int block = DivideUp(pixels.width, kMaxColumns);
  CameraView view;
  view.intrinsics.width = DivideUp(pixels.width, block);
  view.intrinsics.height = DivideUp(pixels.height, block);
  // Block c covers pixels c * block to c * block + block - 1: its centre is half a block on.
  const double half = 0.5 * (block - 1);
  view.intrinsics.fx = pixels.fx / block;
  view.intrinsics.fy = pixels.fy / block;
  view.intrinsics.cx = (pixels.cx - half) / block;
  view.intrinsics.cy = (pixels.cy - half) / block;
  std::vector<std::uint16_t> samples;
  for (int row = 0; row < view.intrinsics.height; ++row)
    for (int column = 0; column < view.intrinsics.width; ++column) {
      const double depth_mm = 1e3 * image.depth_unit_m *
                              BlockMedian(image, column * block, row * block, block, samples);
      view.depth_mm.push_back(
          static_cast<std::uint16_t>(std::lround(std::min<double>(depth_mm, kMaxViewDepth_mm))));
    }
  return view;
}

}  // namespace fallen
