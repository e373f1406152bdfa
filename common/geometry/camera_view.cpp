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

// A number for each block of a row of them, for registers to hold.
using BlockValues = std::array<std::int16_t, kMaxColumns>;

// Registers compare signed numbers more cheaply.
std::int16_t OrderAsSigned(int value) { return static_cast<std::int16_t>(value ^ 0x8000); }
// 0 is "not measured", and last in order.
std::int16_t KeyOf(std::uint16_t depth) { return OrderAsSigned((depth - 1) & 0xFFFF); }

// Depths at places spread evenly over each block of a row, as keys: one place of all blocks after
// the other.
struct BlockSamples {
  std::array<std::array<BlockValues, kSamplesPerSide>, kSamplesPerSide> keys;
  BlockValues looked_at = {};

  BlockSamples() {
    for (auto& row : keys)
      for (BlockValues& of_blocks : row) of_blocks.fill(KeyOf(0));
  }

  BlockValues CountBelow(const BlockValues& limits) const {
    BlockValues counts = {};
    for (const auto& row : keys)
      for (const BlockValues& of_blocks : row)
        for (int block = 0; block < kMaxColumns; ++block)
          counts[block] =
              static_cast<std::int16_t>(counts[block] + (of_blocks[block] < limits[block]));
    return counts;
  }
};

BlockSamples TakeSamples(const DepthImage& image, int first_v, int block) {
  const int step = DivideUp(block, kSamplesPerSide);
  const int width = image.intrinsics.width;
  const int end_v = std::min(first_v + block, image.intrinsics.height);
  BlockSamples samples;
  for (int v = first_v + (step - 1) / 2, row = 0; v < end_v; v += step, ++row) {
    const std::uint16_t* const depth = image.depth.data() + static_cast<std::size_t>(v) * width;
    for (int first_u = 0, column = 0; first_u < width; first_u += block, ++column) {
      const int end_u = std::min(first_u + block, width);
      int place = 0;
      for (int u = first_u + (step - 1) / 2; u < end_u; u += step)
        samples.keys[row][place++][column] = KeyOf(depth[u]);
      samples.looked_at[column] = static_cast<std::int16_t>(samples.looked_at[column] + place);
    }
  }
  return samples;
}

// Median of the measured samples of each block whose pixels begin in row `first_v` [units]; 0 if
// fewer than half are measured.
std::array<std::uint16_t, kMaxColumns> BlockMedians(const DepthImage& image, int first_v,
                                                    int block) {
  const BlockSamples samples = TakeSamples(image, first_v, block);
  BlockValues limits;
  limits.fill(KeyOf(0));
  const BlockValues measured = samples.CountBelow(limits);
  BlockValues half = measured;
  for (std::int16_t& count : half) count = static_cast<std::int16_t>(count / 2);
  // Bit by bit: a median is the greatest number with no more than half of the samples below.
  std::array<std::uint16_t, kMaxColumns> medians = {};
  for (int bit = 15; bit >= 0; --bit) {
    for (int column = 0; column < kMaxColumns; ++column)
      limits[column] = OrderAsSigned(medians[column] | (1 << bit));
    const BlockValues below = samples.CountBelow(limits);
    for (int column = 0; column < kMaxColumns; ++column) {
      const int more = below[column] <= half[column] ? 1 << bit : 0;  // without a branch
      medians[column] = static_cast<std::uint16_t>(medians[column] | more);
    }
  }
  for (int column = 0; column < kMaxColumns; ++column) {
    const bool is_known = measured[column] > 0 && 2 * measured[column] >= samples.looked_at[column];
    medians[column] = static_cast<std::uint16_t>(is_known ? medians[column] + 1 : 0);
  }
  return medians;
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
  for (int row = 0; row < view.intrinsics.height; ++row) {
    const auto medians = BlockMedians(image, row * block, block);
    for (int column = 0; column < view.intrinsics.width; ++column) {
      const double depth_mm = 1e3 * image.depth_unit_m * medians[column];
      view.depth_mm.push_back(
          static_cast<std::uint16_t>(std::lround(std::min<double>(depth_mm, kMaxViewDepth_mm))));
    }
  }
}

}  // namespace fallen
