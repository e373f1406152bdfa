// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tools/frames/frame_source.hpp"
#include "tools/view/feed/feed.hpp"

namespace fallen {

/// Tells how far a recording has been read: the page by the topic "source", at the end stderr too
/// if something had to be left out.
class ReplayReport {
 public:
  /// @param feed  Must outlive this.
  ReplayReport(Feed& feed, const std::string& name, const std::string& camera);

  void Progress(double share_read, const Damage& damage);
  void End(const Damage& damage);

 private:
  Feed& feed_;
  std::string name_;
  std::string camera_;
};

}  // namespace fallen
