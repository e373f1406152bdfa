// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/stage_loop.hpp"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <thread>

namespace fallen {
namespace {

// How long nothing must come before the source counts as idle. Live, a frame that waits for its
// pose shall not wait longer; lossless, a player that stutters must not change the result.
constexpr std::chrono::milliseconds kIdleLive{200};
constexpr std::chrono::milliseconds kIdleLossless{2000};
// How soon a signal to stop is seen.
constexpr std::chrono::milliseconds kPollInterval{50};

}  // namespace

WorkerShare WorkerShare::Parse(const std::string& text) {
  WorkerShare share;
  int length = 0;
  const int fields = std::sscanf(text.c_str(), "%d/%d%n", &share.index, &share.count, &length);
  if (fields != 2 || length != static_cast<int>(text.size()) || share.index < 0 ||
      share.index >= share.count)
    throw std::invalid_argument("--worker: got '" + text + "', expected k/n with 0 <= k < n");
  return share;
}

bool WorkerShare::Takes(std::int64_t seq) const {
  const std::int64_t remainder = seq % count;
  return (remainder < 0 ? remainder + count : remainder) == index;
}

/// Between LCM, which wants a member function and is C below, and the loop: nothing thrown gets
/// past.
class StageLoop::Subscriber {
 public:
  Subscriber(lcm::LCM& lcm, const std::string& channel, std::function<void(Bytes)> handle,
             ServiceReporter& reporter)
      : lcm_(lcm), handle_(std::move(handle)), reporter_(reporter) {
    subscription_ = lcm.subscribe(channel, &Subscriber::Receive, this);
    if (!subscription_) throw std::runtime_error("LCM cannot subscribe to " + channel);
    // The handler only hands over; what waits is bounded in the TaskQueue, where it is counted.
    subscription_->setQueueCapacity(0);
  }
  ~Subscriber() { lcm_.unsubscribe(subscription_); }
  Subscriber(const Subscriber&) = delete;
  Subscriber& operator=(const Subscriber&) = delete;

  void Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept {
    try {
      handle_({static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
    } catch (const std::exception& error) {
      reporter_.CountDamaged(channel + ": " + error.what());
    }
  }

 private:
  lcm::LCM& lcm_;
  std::function<void(Bytes)> handle_;
  ServiceReporter& reporter_;
  lcm::Subscription* subscription_ = nullptr;
};

StageLoop::StageLoop(lcm::LCM& lcm, const StageOptions& options)
    : lcm_(lcm),
      options_(options),
      reporter_(lcm, options.service, options.camera),
      queue_(options.lossless ? TaskQueue::Order::kEveryFrame : TaskQueue::Order::kNewestFrame,
             options.max_waiting_bytes) {}

StageLoop::~StageLoop() = default;

void StageLoop::Subscribe(const std::string& channel, std::function<void(Bytes)> handle) {
  subscribers_.push_back(std::make_unique<Subscriber>(lcm_, channel, std::move(handle), reporter_));
}

void StageLoop::Queue(TaskQueue::Task task) {
  const TaskQueue::Pushed pushed = queue_.Push(std::move(task));
  reporter_.CountLate(pushed.dropped_frames,
                      pushed.refused ? "dropped: more waits than memory is set aside for"
                                     : "dropped a late frame: a newer one is there");
}

void StageLoop::Handle(const std::function<void()>& work) {
  result_begin_ = std::chrono::steady_clock::now();
  RunGuarded(work);
}

void StageLoop::RunGuarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    reporter_.CountDamaged(error.what());
  }
}

void StageLoop::HandleWaiting() {
  while (const auto task = queue_.Pop(std::chrono::milliseconds(0))) Handle(task->work);
}

void StageLoop::WorkUntilClosed() {
  const auto idle = options_.lossless ? kIdleLossless : kIdleLive;
  bool is_idle = true;
  while (!queue_.is_finished()) {
    const auto task = queue_.Pop(idle);
    if (task) Handle(task->work);
    if (!task && !is_idle && on_idle_) Handle(on_idle_);
    is_idle = !task;
  }
  if (!is_idle && on_idle_) Handle(on_idle_);
}

void StageLoop::Drain(const std::function<bool()>& stop_arrived) {
  if (options_.lossless)
    while (lcm_.handleTimeout(0) > 0) {
    }
  queue_.Close();
  while (!queue_.is_finished()) {
    reporter_.PublishStatusIfDue();
    if (stop_arrived()) queue_.Abandon();
    std::this_thread::sleep_for(kPollInterval);
  }
}

int StageLoop::Run(const std::function<bool()>& stop_arrived) {
  std::thread worker([this] { WorkUntilClosed(); });
  int exit_status = 0;
  auto next_second = std::chrono::steady_clock::now();
  while (!stop_arrived()) {
    if (on_every_second_ && std::chrono::steady_clock::now() >= next_second) {
      next_second += std::chrono::seconds(1);
      Post(on_every_second_);
    }
    const auto until_status = reporter_.PublishStatusIfDue();
    const auto timeout = std::min(until_status, kPollInterval);
    if (lcm_.handleTimeout(static_cast<int>(timeout.count())) >= 0) continue;
    LogError("LCM failed to receive");
    exit_status = 1;
    break;
  }
  reporter_.SetState(ServiceState::kStopping, "");
  Drain(stop_arrived);
  worker.join();
  reporter_.PublishStatus();
  return exit_status;
}

}  // namespace fallen
