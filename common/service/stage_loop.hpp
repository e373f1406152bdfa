// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/service/channels.hpp"
#include "fallen/service/service_reporter.hpp"
#include "fallen/service/task_queue.hpp"

/// The loop of a service that turns messages into messages.
namespace fallen {

/// Frames with seq % count == index are this worker's.
struct WorkerShare {
  int index = 0;
  int count = 1;

  /// Reads "k/n". @throws std::invalid_argument unless 0 <= k < n.
  static WorkerShare Parse(const std::string& text);
  bool Takes(std::int64_t seq) const;
};

struct StageOptions {
  std::string service;  ///< as in "fallen-<service>"
  std::string camera = "CAMERA";
  std::string pose_channel = channels::kRobotPose;
  std::string depth_channel;  ///< empty: DEPTH_<camera>
  bool lossless = false;
  WorkerShare worker;
  /// Bound on what waits: a lossless replay may run ahead of the service by 400 depth images, or by
  /// thousands of maps, before frames must go.
  std::size_t max_waiting_bytes = std::size_t{256} << 20;
};

/// Runs a service: the LCM thread decodes, checks and hands over, a worker handles, statuses go
/// out.
///
/// A service registers its handlers, which run in the worker, one at a time; what they throw is
/// logged, the message counted as damaged. Nothing thrown leaves a handler.
class StageLoop {
 public:
  /// @param lcm  Must outlive this. One thread at a time calls its handle().
  StageLoop(lcm::LCM& lcm, const StageOptions& options);
  ~StageLoop();
  StageLoop(const StageLoop&) = delete;
  StageLoop& operator=(const StageLoop&) = delete;

  /// Calls `handle` with each frame of `channel` that this worker takes: the newest, or every one.
  /// `In` has a header.
  template <class In>
  void OnFrame(const std::string& channel, std::function<void(const In&)> handle) {
    Subscribe(channel, [this, channel, handle = std::move(handle)](auto bytes) {
      // Another worker's frame is not worth the time to decode it.
      const auto header = DecodeHeader(bytes, In::getHash());
      if (header && !options_.worker.Takes(header->seq)) return Skip(*header);
      std::string error;
      auto message = Decode<In>(channel, bytes, error);
      if (!message) return reporter_.CountDamagedFrame(error);
      CountReceived(message->header);
      Queue({[message, handle] { handle(*message); }, bytes.size(), true});
    });
  }

  /// Calls `handle` with each message of `channel`, in its place between the frames.
  template <class In>
  void OnMessage(const std::string& channel, std::function<void(const In&)> handle) {
    Subscribe(channel, [this, channel, handle = std::move(handle)](auto bytes) {
      std::string error;
      auto message = Decode<In>(channel, bytes, error);
      if (!message) return reporter_.CountDamaged(error);
      Queue({[message, handle] { handle(*message); }, bytes.size(), false});
    });
  }

  /// Has `work` done in the worker, in its place between the messages: for what comes from
  /// elsewhere. Thread-safe.
  void Post(std::function<void()> work) { Queue({std::move(work), 0, false}); }

  /// Calls `handle` in the worker once a second while the loop runs.
  void OnEverySecond(std::function<void()> handle) { on_every_second_ = std::move(handle); }

  /// Calls `handle` in the worker once after nothing has come for a while, and at the end.
  void OnIdle(std::function<void()> handle) { on_idle_ = std::move(handle); }

  /// Sends a result: from handlers only. Its time counts from the start of the handler, or from the
  /// result before in the same handler.
  template <class Out>
  void Publish(const std::string& channel, const Out& message) {
    const auto now = std::chrono::steady_clock::now();
    reporter_.PublishResult(channel, message,
                            std::chrono::duration<double, std::milli>(now - result_begin_).count());
    result_begin_ = std::chrono::steady_clock::now();
  }

  /// The usual stage: one message in, one out.
  template <class In, class Out>
  void Connect(const std::string& in, const std::string& out,
               std::function<Out(const In&)> convert) {
    OnFrame<In>(in, [this, out, convert = std::move(convert)](const In& message) {
      Publish(out, convert(message));
    });
  }

  /// Runs a part of a handler by itself: what it throws is counted, and the handler goes on.
  void RunGuarded(const std::function<void()>& work);

  ServiceReporter& reporter() { return reporter_; }
  const StageOptions& options() const { return options_; }

  /// Works off what waits in the caller's thread: for tests and tools, instead of Run.
  void HandleWaiting();

  /// Runs until `stop_arrived` says so, then stops cleanly: lossless, what has arrived is worked
  /// off first, unless a second stop arrives.
  /// @return Exit status: 0, or 1 if LCM failed.
  int Run(const std::function<bool()>& stop_arrived);

 private:
  using Bytes = std::span<const std::uint8_t>;
  class Subscriber;

  /// A message to hand over, or nothing and why in `error`.
  template <class In>
  static std::shared_ptr<const In> Decode(const std::string& channel, Bytes bytes,
                                          std::string& error) {
    auto decoded = DecodeMessage<In>(bytes);
    if (decoded) return std::make_shared<const In>(std::move(*decoded.message));
    error = channel + ": " + decoded.error;
    return nullptr;
  }

  void CountReceived(const header_t& header) {
    reporter_.CountReceived(header.utime, header.seq, header.sensor_name);
  }
  void Skip(const header_t& header) {
    CountReceived(header);
    reporter_.CountSkipped();
  }
  void Subscribe(const std::string& channel, std::function<void(Bytes)> handle);
  void Queue(TaskQueue::Task task);
  void Handle(const std::function<void()>& work);
  void WorkUntilClosed();
  void Drain(const std::function<bool()>& stop_arrived);

  lcm::LCM& lcm_;
  const StageOptions options_;
  ServiceReporter reporter_;
  TaskQueue queue_;
  std::vector<std::unique_ptr<Subscriber>> subscribers_;
  std::function<void()> on_idle_;
  std::function<void()> on_every_second_;
  std::chrono::steady_clock::time_point result_begin_;
};

}  // namespace fallen
