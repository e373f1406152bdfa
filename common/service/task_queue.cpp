// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/task_queue.hpp"

#include <utility>

namespace fallen {

TaskQueue::Pushed TaskQueue::Push(Task task) {
  const std::lock_guard lock(mutex_);
  Pushed pushed;
  if (is_closed_) return {task.is_frame ? 1 : 0, false};
  if (order_ == Order::kNewestFrame && task.is_frame) {
    for (auto older = tasks_.begin(); older != tasks_.end();) {
      if (!older->is_frame) {
        ++older;
        continue;
      }
      bytes_ -= older->bytes;
      older = tasks_.erase(older);
      ++pushed.dropped_frames;
    }
  }
  if (bytes_ + task.bytes > max_bytes_) {
    pushed.refused = true;
    pushed.dropped_frames += task.is_frame ? 1 : 0;
    return pushed;
  }
  bytes_ += task.bytes;
  tasks_.push_back(std::move(task));
  changed_.notify_one();
  return pushed;
}

std::optional<TaskQueue::Task> TaskQueue::Pop(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return !tasks_.empty() || is_closed_; });
  if (tasks_.empty()) return std::nullopt;
  Task task = std::move(tasks_.front());
  tasks_.pop_front();
  bytes_ -= task.bytes;
  return task;
}

void TaskQueue::Close() {
  if (order_ == Order::kNewestFrame) return Abandon();
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

void TaskQueue::Abandon() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  tasks_.clear();
  bytes_ = 0;
  changed_.notify_all();
}

bool TaskQueue::is_finished() const {
  const std::lock_guard lock(mutex_);
  return is_closed_ && tasks_.empty();
}

std::size_t TaskQueue::size() const {
  const std::lock_guard lock(mutex_);
  return tasks_.size();
}

}  // namespace fallen
