// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/frame_gate.hpp"

#include <cstdlib>

namespace fallen {

FrameGate::~FrameGate() = default;

void FrameGate::Admit() {
  {
    const std::lock_guard lock(mutex_);
    ++admitted_;
  }
  changed_.notify_one();
}

void FrameGate::Open() {
  {
    const std::lock_guard lock(mutex_);
    open_ = true;
  }
  changed_.notify_all();
}

void* FrameGate::allocateFrameBuffer(int size) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return open_ || admitted_ > 0; });
    if (!open_) --admitted_;
  }
  return std::malloc(static_cast<std::size_t>(size));
}

void FrameGate::freeFrameBuffer(void* buffer) { std::free(buffer); }

}  // namespace fallen
