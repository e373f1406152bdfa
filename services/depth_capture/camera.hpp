// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "fallen/geometry/depth_image.hpp"

namespace fallen {

/// A picture with the time that the camera's own clock gave it.
struct CameraFrame {
  DepthImage image;
  std::int64_t device_time_us = 0;  ///< unrelated to any other clock; starts anywhere
  std::int64_t device_index = 0;    ///< counts what the camera took, also what never got here
};

/// The camera is not there, cannot be opened, or has gone: it may come back.
class CameraUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open camera that delivers. Closes when destroyed.
class Camera {
 public:
  virtual ~Camera() = default;

  /// The newest frame that was not read yet; waits for one up to `timeout`.
  /// @return Nothing if none came in that time.
  /// @throws CameraUnavailable once the camera has gone; BadFrame for one that makes no sense.
  virtual std::optional<CameraFrame> Read(std::chrono::milliseconds timeout) = 0;

  /// "PrimeSense PS1080 (1d27/0601@1/5), 640x480 30 Hz 1mm".
  virtual std::string description() const = 0;
};

}  // namespace fallen
