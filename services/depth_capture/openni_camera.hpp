// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "services/depth_capture/camera.hpp"
#include "services/depth_capture/depth_mode.hpp"

namespace fallen {

/// A depth camera behind OpenNI2: PrimeSense Carmine, Asus Xtion, Kinect 2 (with libfreenect2's
/// driver), and whatever else there is a driver for. Pictures are never mirrored.
class OpenNiCamera : public Camera {
 public:
  /// @param uri     As ListCameras tells it; empty: the first camera that can be opened.
  /// @param record  Everything that the camera takes goes into this .oni file too, whether it is
  /// read
  ///                here or not. Complete once the camera is closed. An existing file is replaced.
  /// @throws CameraUnavailable, UnsupportedMode, or std::runtime_error if `record` cannot be
  /// written.
  OpenNiCamera(const std::string& uri, const DepthMode& mode,
               const std::optional<std::filesystem::path>& record = std::nullopt);
  ~OpenNiCamera() override;

  std::optional<CameraFrame> Read(std::chrono::milliseconds timeout) override;
  std::string description() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fallen
