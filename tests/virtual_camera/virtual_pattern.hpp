// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

/// What the virtual camera shows and how it is steered: shared by the driver and by the tests.
namespace fallen::virtual_camera {

/// Field of view of a PrimeSense Carmine 1.08 and an Asus Xtion, as their driver states it [rad].
inline constexpr double kHorizontalFovRad = 1.0144686707507438;
inline constexpr double kVerticalFovRad = 0.78980943449644714;

/// Device clock of a stream's first frame [us]; each further frame is 1e6 / rate later.
inline constexpr std::uint64_t kFirstTimestampUs = 5'000'000;

/// Largest depth in units of 1 mm and of 100 um. Both modes show the same numbers.
inline constexpr int kMaxDepth = 10000;

/// Environment variables that the driver reads when OpenNI2 loads it.
///
/// Control: a file that is read over and over; its first word is the camera's state:
///   `plugged` (also if there is no such file), `unplugged`, `silent` (there, but sends no frames),
///   `refusing` (there, but cannot be opened).
inline constexpr char kControlVariable[] = "FALLEN_VIRTUAL_CAMERA_CONTROL";
/// Frames to play in place of the pattern: raw 16-bit little-endian pictures of the chosen size,
/// one after the other, over and over.
inline constexpr char kFramesVariable[] = "FALLEN_VIRTUAL_CAMERA_FRAMES";
/// How many cameras there are: virtual://0, virtual://1, ... Default 1.
inline constexpr char kCountVariable[] = "FALLEN_VIRTUAL_CAMERA_COUNT";
/// `0`: plugging and unplugging are not announced, as where no udev runs: only starting OpenNI2
/// anew finds a camera.
inline constexpr char kHotplugVariable[] = "FALLEN_VIRTUAL_CAMERA_HOTPLUG";

/// Depth of pixel (`x`, `y`) of the frame counted from 1, as seen without mirroring.
///
/// Every frame differs from its neighbours in every pixel, no row or column is like the next, none
/// is symmetric, and there are holes. The first pixel holds the frame's number.
constexpr std::uint16_t PatternDepth(int x, int y, int frame) {
  if (x == 0 && y == 0) return static_cast<std::uint16_t>(frame % kMaxDepth);
  const int value = (37 * x + 101 * y + 53 * frame) % 4801;
  return value < 200 ? std::uint16_t{0} : static_cast<std::uint16_t>(500 + value);
}

/// The whole picture of a frame, row-major.
inline std::vector<std::uint16_t> PatternFrame(int width, int height, int frame) {
  std::vector<std::uint16_t> depth;
  depth.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) depth.push_back(PatternDepth(x, y, frame));
  return depth;
}

}  // namespace fallen::virtual_camera
