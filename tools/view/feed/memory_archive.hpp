// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>

#include "tools/view/feed/frame_archive.hpp"

namespace fallen {

/// The newest frames, as many as fit into so much memory; at least one.
class MemoryArchive : public FrameArchive {
 public:
  explicit MemoryArchive(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  void Append(std::shared_ptr<const Bytes> frame) override;
  std::int64_t first() const override { return first_; }
  std::int64_t count() const override { return first_ + static_cast<std::int64_t>(frames_.size()); }
  std::shared_ptr<const Bytes> Read(std::int64_t index) override;

 private:
  const std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::int64_t first_ = 0;
  std::deque<std::shared_ptr<const Bytes>> frames_;
};

}  // namespace fallen
