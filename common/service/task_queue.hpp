// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

namespace fallen {

/// What the worker of a service has to do next: messages, decoded and waiting. Thread-safe.
///
/// Live, only the newest frame waits: an older one that nobody has begun with is dropped when the
/// next arrives. Lossless, all wait in order. What is not a frame (a pose) is never dropped but for
/// the bound on memory, and keeps its place in the order.
class TaskQueue {
 public:
  enum class Order { kNewestFrame, kEveryFrame };

  struct Task {
    std::function<void()> work;
    std::size_t bytes = 0;  ///< memory that it holds, for the bound
    bool is_frame = false;
  };

  /// @param max_bytes  What does not fit is refused.
  TaskQueue(Order order, std::size_t max_bytes) : order_(order), max_bytes_(max_bytes) {}

  /// How many frames had to go: older ones for this one, or this one itself.
  struct Pushed {
    std::int64_t dropped_frames = 0;
    bool refused = false;  ///< the bound on memory is reached
  };
  Pushed Push(Task task);

  /// Waits for a task; nothing if none came within `timeout`, or the queue is closed and empty.
  std::optional<Task> Pop(std::chrono::milliseconds timeout);

  /// No more tasks. Lossless, those that wait are still handed out; live, they are dropped.
  void Close();
  /// Close, and nothing more is handed out.
  void Abandon();

  bool is_finished() const;  ///< closed, and nothing waits
  std::size_t size() const;

 private:
  const Order order_;
  const std::size_t max_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  std::size_t bytes_ = 0;
  bool is_closed_ = false;
};

}  // namespace fallen
