// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>

#include "fallen/messages/conversions.hpp"
#include "fallen/service/service_reporter.hpp"
#include "services/depth_capture/camera_keeper.hpp"
#include "services/depth_capture/capture_plan.hpp"
#include "services/depth_capture/device_clock.hpp"
#include "services/depth_capture/oni_file.hpp"

namespace fallen {

/// Publishes depth images from a camera or from a recording, and its status at 1 Hz.
class DepthCaptureService {
 public:
  /// @param lcm  Must outlive this.
  /// @throws std::runtime_error if the plan's recording cannot be played; the camera's mode, too,
  /// if the camera is there. A camera that is not there is waited for.
  DepthCaptureService(lcm::LCM& lcm, const std::string& camera_name, const CapturePlan& plan);

  /// Captures until `stop_arrived` says so, or to the end of a recording that is not looped.
  /// @throws UnsupportedMode if a camera that was waited for turns out not to do what was asked.
  void Run(const std::function<bool()>& stop_arrived);

 private:
  using Clock = std::chrono::steady_clock;

  void Capture();
  void Play(const std::function<bool()>& stop_arrived);
  bool WaitUntil(Clock::time_point time, const std::function<bool()>& stop_arrived);
  void Publish(StampedDepthImage image, Clock::time_point begin);

  const std::string camera_name_;
  const CapturePlan plan_;
  ServiceReporter reporter_;
  const std::optional<Eigen::Isometry3d> T_robot_camera_;
  std::int64_t seq_ = 0;

  std::optional<CameraKeeper> keeper_;  // with a camera
  DeviceClock clock_;
  int connections_ = 0;

  std::optional<OniFile> file_;  // with a recording
  std::int64_t loop_offset_us_ = 0;
};

}  // namespace fallen
