// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "openni_driver.hpp"

namespace fallen::virtual_camera {

/// Modes that the camera offers; the first is the one it starts in.
std::span<const OniVideoMode> SupportedModes();

/// Depth stream of the virtual camera: a thread that raises frames at the mode's rate.
///
/// Like the real drivers it mirrors unless told otherwise, and like them it answers the properties
/// that OpenNI2's recorder stores and its player needs (video mode, stride, cropping, field of
/// view).
class VirtualStream : public oni::driver::StreamBase {
 public:
  /// @param sends_frames  Asked before each frame; false keeps the frame back.
  /// @param raw_frames    Pictures to play, or empty for the pattern. Must outlive the stream.
  VirtualStream(std::function<bool()> sends_frames, const std::vector<std::uint16_t>& raw_frames);
  ~VirtualStream() override;

  OniStatus start() override;
  void stop() override;
  OniStatus getProperty(int id, void* data, int* size) override;
  OniStatus setProperty(int id, const void* data, int size) override;
  OniBool isPropertySupported(int id) override;

 private:
  void Run();
  void Raise(int frame_number);
  void Fill(int frame_number, std::uint16_t* depth) const;

  std::function<bool()> sends_frames_;
  const std::vector<std::uint16_t>& raw_frames_;
  OniVideoMode mode_;
  OniBool mirrored_ = TRUE;
  std::atomic<bool> running_{false};
  std::thread thread_;
};

}  // namespace fallen::virtual_camera
