// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/camera_keeper.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fallen {
namespace {

std::string Seconds(std::chrono::milliseconds time) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f s", std::chrono::duration<double>(time).count());
  return text;
}

}  // namespace

CameraKeeper::CameraKeeper(Open open, const KeeperOptions& options)
    : open_(std::move(open)), options_(options), pause_(options.first_retry) {}

std::optional<CameraFrame> CameraKeeper::Read(Clock::time_point now,
                                              std::chrono::milliseconds timeout) {
  OpenIfDue(now);
  if (!camera_) return std::nullopt;
  try {
    std::optional<CameraFrame> frame = camera_->Read(timeout);
    if (frame) {
      last_frame_ = now;
      // Only now: a camera that opens but never delivers must not be tried without pause.
      pause_ = options_.first_retry;
      attempt_ = 0;
    } else if (now - last_frame_ > options_.lost_after) {
      Lose(now, camera_->description() + ": sent nothing for " + Seconds(options_.lost_after));
    }
    return frame;
  } catch (const CameraUnavailable& error) {
    Lose(now, error.what());
    return std::nullopt;
  }
}

void CameraKeeper::OpenIfDue(Clock::time_point now) {
  if (camera_ || now < retry_at_) return;
  ++attempt_;
  try {
    camera_ = open_(attempt_);
  } catch (const CameraUnavailable& error) {
    return Lose(now, error.what());
  }
  ++connections_;
  last_frame_ = now;
  text_ = camera_->description();
}

void CameraKeeper::Lose(Clock::time_point now, const std::string& reason) {
  camera_.reset();
  text_ = reason + "; tried again in " + Seconds(pause_);
  retry_at_ = now + pause_;
  pause_ = std::min(2 * pause_, options_.longest_retry);
}

}  // namespace fallen
