// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/camera_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fallen {
namespace {

constexpr int kMaxColumns = 32;
// Samples along each side of a block: the median of 25 is steady enough for 0.3 m more or less.
constexpr int kSamplesPerSide = 5;

int DivideUp(int value, int divisor) { return (value + divisor - 1) / divisor; }

// Depths of a block, at places spread evenly. 0 is "not measured", and last in order.
struct BlockSamples {
  static constexpr int kRoom = 32;  // for 25, in whole vector registers

  std::array<std::uint16_t, kRoom> less_one;  // depth - 1
  int looked_at = 0;
  int measured = 0;

  BlockSamples() { less_one.fill(0xFFFF); }

  void Add(std::uint16_t depth) {
    less_one[looked_at++] = static_cast<std::uint16_t>(depth - 1);
    measured += depth != 0;
  }

  int CountBelow(std::uint16_t limit) const {
    std::uint16_t count = 0;
    for (const std::uint16_t sample : less_one)
      count = static_cast<std::uint16_t>(count + (sample < limit));
    return count;
  }

  // The median, bit by bit: it is the greatest number with no more than half of the samples below.
  std::uint16_t Median() const {
    std::uint16_t median = 0;
    for (int bit = 15; bit >= 0; --bit) {
      const auto candidate = static_cast<std::uint16_t>(median | (1 << bit));
      if (CountBelow(candidate) <= measured / 2) median = candidate;
    }
    return static_cast<std::uint16_t>(median + 1);
  }
};
static_assert(kSamplesPerSide * kSamplesPerSide <= BlockSamples::kRoom);

/// Median of the measured samples of a block [units]; 0 if fewer than half are measured.
std::uint16_t BlockMedian(const DepthImage& image, int first_u, int first_v, int block) {
  const int step = DivideUp(block, kSamplesPerSide);
  const int end_u = std::min(first_u + block, image.intrinsics.width);
  const int end_v = std::min(first_v + block, image.intrinsics.height);
  BlockSamples samples;
  for (int v = first_v + (step - 1) / 2; v < end_v; v += step)
    for (int u = first_u + (step - 1) / 2; u < end_u; u += step)
      samples.Add(image.depth[static_cast<std::size_t>(v) * image.intrinsics.width + u]);
  if (samples.measured == 0 || 2 * samples.measured < samples.looked_at) return 0;
  return samples.Median();
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
  CameraView view;
  MakeCameraView(image, view);
  return view;
}

void MakeCameraView(const DepthImage& image, CameraView& view) {
  image.Validate();
  const CameraIntrinsics& pixels = image.intrinsics;
  const int block = DivideUp(pixels.width, kMaxColumns);
  view.intrinsics.width = DivideUp(pixels.width, block);
  view.intrinsics.height = DivideUp(pixels.height, block);
  // Block c covers pixels c * block to c * block + block - 1: its centre is half a block on.
  const double half = 0.5 * (block - 1);
  view.intrinsics.fx = pixels.fx / block;
  view.intrinsics.fy = pixels.fy / block;
  view.intrinsics.cx = (pixels.cx - half) / block;
  view.intrinsics.cy = (pixels.cy - half) / block;
  view.depth_mm.clear();
  for (int row = 0; row < view.intrinsics.height; ++row)
    for (int column = 0; column < view.intrinsics.width; ++column) {
      const double depth_mm =
          1e3 * image.depth_unit_m * BlockMedian(image, column * block, row * block, block);
      view.depth_mm.push_back(
          static_cast<std::uint16_t>(std::lround(std::min<double>(depth_mm, kMaxViewDepth_mm))));
    }
}

}  // namespace fallen
