// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <utility>

namespace fallen {

/// A thread that fills a feed until it is told to stop.
class SourceThread {
 public:
  /// @param run  Looks at the flag often, and returns soon after it is set. Throws nothing.
  template <class Run>
  explicit SourceThread(Run run) : thread_([this, run = std::move(run)] { run(is_stopping_); }) {}
  ~SourceThread() {
    is_stopping_ = true;
    thread_.join();
  }
  SourceThread(const SourceThread&) = delete;
  SourceThread& operator=(const SourceThread&) = delete;

 private:
  std::atomic<bool> is_stopping_ = false;
  std::thread thread_;
};

}  // namespace fallen
