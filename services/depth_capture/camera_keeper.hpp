// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "services/depth_capture/camera.hpp"

namespace fallen {

/// How patient a CameraKeeper is. All > 0.
struct KeeperOptions {
  std::chrono::milliseconds lost_after{3000};
  std::chrono::milliseconds first_retry{500};
  std::chrono::milliseconds longest_retry{10000};
};

/// Keeps a camera open: opens it, notices when it goes, tries again with growing pauses, goes on
/// when it comes back. Knows no clock of its own.
class CameraKeeper {
 public:
  using Clock = std::chrono::steady_clock;
  /// Opens the camera. @param attempt  From 1, since a camera was last there.
  using Open = std::function<std::unique_ptr<Camera>(int attempt)>;

  CameraKeeper(Open open, const KeeperOptions& options);

  /// The next frame, opening the camera if it is time for that.
  ///
  /// Waits up to `timeout` for a frame of an open camera; comes back at once when there is none,
  /// and `retry_at()` says when there is something to do again.
  /// @throws What `open` and the camera throw, but for CameraUnavailable.
  std::optional<CameraFrame> Read(Clock::time_point now, std::chrono::milliseconds timeout);

  /// Opens the camera if it is not and it is time to try.
  /// @throws What `open` throws, but for CameraUnavailable.
  void OpenIfDue(Clock::time_point now);

  bool is_open() const { return camera_ != nullptr; }
  /// With no camera open: when it is next tried.
  Clock::time_point retry_at() const { return retry_at_; }
  /// The camera that is open, or why none is and when it is tried again.
  const std::string& text() const { return text_; }
  /// How many times a camera was opened: changes with each new one.
  int connections() const { return connections_; }

 private:
  void Lose(Clock::time_point now, const std::string& reason);

  Open open_;
  KeeperOptions options_;
  std::unique_ptr<Camera> camera_;
  std::string text_ = "not opened yet";
  int attempt_ = 0;
  int connections_ = 0;
  std::chrono::milliseconds pause_;
  Clock::time_point retry_at_{};
  Clock::time_point last_frame_{};
};

}  // namespace fallen
