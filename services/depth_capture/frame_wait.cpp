// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/frame_wait.hpp"

#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace fallen {
namespace {

/// A thread that does one piece of work after the other.
class WaitingThread {
 public:
  using Work = std::packaged_task<openni::Status()>;

  WaitingThread() {
    std::thread([this] { Run(); }).detach();
  }

  openni::Status Do(Work work) {
    std::future<openni::Status> result = work.get_future();
    {
      const std::lock_guard lock(mutex_);
      works_.push_back(std::move(work));
    }
    changed_.notify_one();
    return result.get();
  }

 private:
  [[noreturn]] void Run() {
    for (;;) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !works_.empty(); });
      Work work = std::move(works_.front());
      works_.pop_front();
      lock.unlock();
      work();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Work> works_;
};

openni::Status WaitHere(openni::VideoStream& stream, int timeout_ms, openni::VideoFrameRef& frame) {
  openni::VideoStream* streams[] = {&stream};
  int ready = -1;
  const openni::Status status = openni::OpenNI::waitForAnyStream(streams, 1, &ready, timeout_ms);
  if (status != openni::STATUS_OK) return status;
  const openni::Status taken = stream.readFrame(&frame);
  if (taken == openni::STATUS_OK && !frame.isValid()) return openni::STATUS_TIME_OUT;
  return taken;
}

}  // namespace

openni::Status WaitForFrame(openni::VideoStream& stream, int timeout_ms,
                            openni::VideoFrameRef& frame) {
  // Never destroyed: it must outlast every use of OpenNI2, also one at the end of the process.
  static WaitingThread& thread = *new WaitingThread;
  return thread.Do(WaitingThread::Work([&] { return WaitHere(stream, timeout_ms, frame); }));
}

}  // namespace fallen
