// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "fallen/geometry/depth_image.hpp"
#include "services/depth_capture/depth_mode.hpp"

/// From what a depth driver delivers to a depth image.
namespace fallen {

/// A frame that makes no sense; the next one may.
class BadFrame : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A frame as it lies in the driver's memory.
struct RawDepthFrame {
  std::span<const std::uint8_t> bytes;  ///< 16-bit values, little-endian, row by row
  int width = 0;                        ///< of the part that was read out [px]
  int height = 0;
  int stride_bytes = 0;  ///< from row to row, >= 2 width
  int full_width = 0;    ///< of the whole picture that the field of view is stated for [px]
  int full_height = 0;
  int crop_x = 0;  ///< where the part lies in the whole [px]
  int crop_y = 0;
  DepthUnit unit = DepthUnit::k1Mm;
};

/// Full opening angles of the whole picture [rad], both in (0, pi).
struct FieldOfView {
  double horizontal_rad = 0;
  double vertical_rad = 0;
};

/// Copies the values out and states the camera that belongs to them.
///
/// Focal length f = (width / 2) / tan(fov / 2); the principal point is the middle of the whole
/// picture, which is (width - 1) / 2 as pixel centres are whole numbers here.
/// @param mirrored  The driver has swapped left and right: swaps them back, or whoever lies to the
///                  left would be reported to the right.
/// @throws BadFrame naming what does not fit together.
DepthImage ToDepthImage(const RawDepthFrame& frame, const FieldOfView& field_of_view,
                        bool mirrored);

}  // namespace fallen
