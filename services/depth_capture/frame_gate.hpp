// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenNI.h>

#include <condition_variable>
#include <mutex>

namespace fallen {

/// Lets OpenNI2's player raise one frame for each that was asked for, and no more.
///
/// OpenNI2 keeps only the newest frame of a stream, and its "on demand" playback can be asked twice
/// for one frame: any stream's frame wakes every waiting thread, which then asks again. The frame
/// that is too early would push out the one that nobody has read yet. The player must get memory
/// for a frame before it can raise it, so this makes it wait for the memory. Must outlive the
/// stream that it serves, and the stream's frames.
class FrameGate : public openni::VideoStream::FrameAllocator {
 public:
  ~FrameGate() override;

  /// One more frame may come.
  void Admit();
  /// From now on nothing waits: for closing the stream.
  void Open();

 private:
  void* allocateFrameBuffer(int size) override;
  void freeFrameBuffer(void* buffer) override;

  std::mutex mutex_;
  std::condition_variable changed_;
  int admitted_ = 0;
  bool open_ = false;
};

}  // namespace fallen
