// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace fallen {

/// Threads to start for a wish of `threads`; 0 means as many as the machine has.
inline int ThreadCount(int threads) {
  if (threads > 0) return threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls `task(i)` for i in [0, count), each once, on up to `threads` threads including this one.
/// Which thread does which is open, so tasks must write to places of their own. The first exception
/// ends the rest and is thrown on, after all threads have stopped.
template <class Task>
void ParallelFor(int count, int threads, const Task& task) {
  std::atomic<int> next{0};
  std::exception_ptr first_error;
  std::once_flag is_noted;
  const auto work = [&] {
    try {
      for (int i = next++; i < count; i = next++) task(i);
    } catch (...) {
      std::call_once(is_noted, [&] { first_error = std::current_exception(); });
      next = count;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int t = 1; t < std::min(threads, count); ++t) helpers.emplace_back(work);
    work();
  }
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace fallen
