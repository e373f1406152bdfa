// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "fallen/detection/detector.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/view/feed/feed.hpp"
#include "tools/view/feed/replay_report.hpp"

namespace fallen {

/// Fills a feed with the frames of a recording, detected in this process.
class ReplaySource {
 public:
  /// @param feed  Must outlive this.
  ReplaySource(Feed& feed, std::unique_ptr<FrameSource> recording, Detector detector,
               const std::string& name);

  /// Reads to the end, as fast as it goes, or until `is_stopping`. What goes wrong is told to the
  /// page and, in one line, on stderr.
  void Run(const std::atomic<bool>& is_stopping);

 private:
  void Detect(const Frame& frame);

  Feed& feed_;
  std::unique_ptr<FrameSource> recording_;
  Detector detector_;
  ReplayReport report_;
};

}  // namespace fallen
