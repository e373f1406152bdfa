// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/raw_depth_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

namespace fallen {
namespace {

constexpr std::size_t kBytesPerPixel = sizeof(std::uint16_t);
constexpr int kMaxSide = 8192;  // as CameraIntrinsics

void RequireUsable(const RawDepthFrame& frame, const FieldOfView& fov) {
  const auto refuse = [](const std::string& text) { throw BadFrame("depth frame: " + text); };
  if (frame.width < 1 || frame.height < 1 || frame.width > kMaxSide || frame.height > kMaxSide)
    refuse("size is " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
           ", must be 1 to 8192 each");
  if (frame.crop_x < 0 || frame.crop_y < 0 || frame.crop_x + frame.width > frame.full_width ||
      frame.crop_y + frame.height > frame.full_height)
    refuse("part is not inside the picture of " + std::to_string(frame.full_width) + "x" +
           std::to_string(frame.full_height));
  const std::size_t row = static_cast<std::size_t>(frame.width) * kBytesPerPixel;
  if (frame.stride_bytes < 0 || static_cast<std::size_t>(frame.stride_bytes) < row)
    refuse("stride is " + std::to_string(frame.stride_bytes) + " bytes, must be at least " +
           std::to_string(row));
  const std::size_t needed =
      static_cast<std::size_t>(frame.height - 1) * static_cast<std::size_t>(frame.stride_bytes) +
      row;
  if (frame.bytes.size() < needed)
    refuse("has " + std::to_string(frame.bytes.size()) + " bytes, expected " +
           std::to_string(needed));
  for (const double angle : {fov.horizontal_rad, fov.vertical_rad})
    if (!(angle > 0 && angle < std::numbers::pi))
      refuse("field of view is " + std::to_string(angle) + " rad, must be in (0, pi)");
}

double FocalLength(int side, double angle_rad) { return 0.5 * side / std::tan(0.5 * angle_rad); }

CameraIntrinsics IntrinsicsOf(const RawDepthFrame& frame, const FieldOfView& fov, bool mirrored) {
  CameraIntrinsics camera;
  camera.width = frame.width;
  camera.height = frame.height;
  camera.fx = FocalLength(frame.full_width, fov.horizontal_rad);
  camera.fy = FocalLength(frame.full_height, fov.vertical_rad);
  camera.cx = 0.5 * (frame.full_width - 1) - frame.crop_x;
  camera.cy = 0.5 * (frame.full_height - 1) - frame.crop_y;
  if (mirrored) camera.cx = frame.width - 1 - camera.cx;
  return camera;
}

}  // namespace

DepthImage ToDepthImage(const RawDepthFrame& frame, const FieldOfView& field_of_view,
                        bool mirrored) {
  RequireUsable(frame, field_of_view);
  const auto width = static_cast<std::size_t>(frame.width);
  const auto height = static_cast<std::size_t>(frame.height);
  const auto stride = static_cast<std::size_t>(frame.stride_bytes);
  DepthImage image;
  image.intrinsics = IntrinsicsOf(frame, field_of_view, mirrored);
  image.depth_unit_m = MetresPerUnit(frame.unit);
  image.depth.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    std::uint16_t* row = image.depth.data() + y * width;
    std::memcpy(row, frame.bytes.data() + y * stride, width * kBytesPerPixel);
    if (mirrored) std::reverse(row, row + width);
  }
  return image;
}

}  // namespace fallen
