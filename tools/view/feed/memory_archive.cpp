// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/memory_archive.hpp"

#include <utility>

namespace fallen {

void MemoryArchive::Append(std::shared_ptr<const Bytes> frame) {
  bytes_ += frame->size();
  frames_.push_back(std::move(frame));
  while (bytes_ > max_bytes_ && frames_.size() > 1) {
    bytes_ -= frames_.front()->size();
    frames_.pop_front();
    ++first_;
  }
}

std::shared_ptr<const MemoryArchive::Bytes> MemoryArchive::Read(std::int64_t index) {
  return frames_.at(static_cast<std::size_t>(index - first_));
}

}  // namespace fallen
