// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/stage_loop.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "fallen/fallen_persons_t.hpp"
#include "fallen/pose_t.hpp"

namespace fallen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr char kIn[] = "IN";
constexpr char kOut[] = "OUT";

fallen_persons_t FrameNumber(std::int64_t seq) {
  fallen_persons_t message{};
  message.header.utime = 1000 * seq;
  message.header.seq = seq;
  message.header.sensor_name = "CAMERA";
  return message;
}

/// Keeps what arrives on a channel.
template <class Message>
class Collector {
 public:
  Collector(lcm::LCM& lcm, const std::string& channel) {
    lcm.subscribe(channel, &Collector::Receive, this)->setQueueCapacity(0);
  }
  void Receive(const lcm::ReceiveBuffer*, const std::string&, const Message* message) {
    messages.push_back(*message);
  }
  std::vector<Message> messages;
};

class StageLoopTest : public testing::Test {
 protected:
  StageLoopTest() : lcm_("memq://") {}

  static StageOptions Lossless() {
    StageOptions options;
    options.service = "example";
    options.lossless = true;
    return options;
  }
  static StageOptions Live() {
    StageOptions options = Lossless();
    options.lossless = false;
    return options;
  }
  void Deliver() {
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void Send(std::int64_t seq) {
    const fallen_persons_t message = FrameNumber(seq);
    lcm_.publish(kIn, &message);
  }
  /// A request to stop once so much time is over.
  static std::function<bool()> After(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    return [end] { return std::chrono::steady_clock::now() >= end; };
  }
  static void Echo(StageLoop& loop) {
    loop.Connect<fallen_persons_t, fallen_persons_t>(
        kIn, kOut, [](const fallen_persons_t& message) { return message; });
  }
  static std::vector<std::int64_t> Numbers(const Collector<fallen_persons_t>& collector) {
    std::vector<std::int64_t> numbers;
    for (const auto& message : collector.messages) numbers.push_back(message.header.seq);
    return numbers;
  }

  lcm::LCM lcm_;
};

TEST_F(StageLoopTest, LosslessHandlesEveryFrameInOrder) {
  StageLoop loop(lcm_, Lossless());
  Echo(loop);
  Collector<fallen_persons_t> results(lcm_, kOut);
  for (int seq = 0; seq < 100; ++seq) Send(seq);
  Deliver();
  loop.HandleWaiting();
  Deliver();
  EXPECT_EQ(Numbers(results).size(), 100U);
  EXPECT_TRUE(std::is_sorted(results.messages.begin(), results.messages.end(),
                             [](auto& a, auto& b) { return a.header.seq < b.header.seq; }));
  EXPECT_EQ(loop.reporter().Status().received, 100);
  EXPECT_EQ(loop.reporter().Status().published, 100);
}

TEST_F(StageLoopTest, LiveHandlesTheNewestAndCountsWhatWasLate) {
  StageLoop loop(lcm_, Live());
  Echo(loop);
  Collector<fallen_persons_t> results(lcm_, kOut);
  for (int seq = 0; seq < 5; ++seq) Send(seq);
  Deliver();
  loop.HandleWaiting();
  Deliver();
  EXPECT_THAT(Numbers(results), ElementsAre(4));
  EXPECT_EQ(loop.reporter().Status().received, 5);
  EXPECT_EQ(loop.reporter().Status().dropped_late, 4);
  EXPECT_EQ(loop.reporter().Status().lost_upstream, 0);
}

TEST_F(StageLoopTest, GapsInSeqAreCountedAsLostUpstream) {
  StageLoop loop(lcm_, Lossless());
  Echo(loop);
  for (const int seq : {0, 1, 5, 6}) Send(seq);
  Deliver();
  EXPECT_EQ(loop.reporter().Status().lost_upstream, 3);
}

TEST_F(StageLoopTest, BrokenMessageIsCountedNotFatalAndNoLoss) {
  StageLoop loop(lcm_, Lossless());
  Echo(loop);
  Collector<fallen_persons_t> results(lcm_, kOut);
  Send(0);
  const std::vector<std::uint8_t> broken(40, 0xA5);  // in the place of seq 1
  lcm_.publish(kIn, broken.data(), static_cast<unsigned>(broken.size()));
  lcm_.publish(kIn, broken.data(), 0);
  Deliver();
  loop.HandleWaiting();
  service_status_t status = loop.reporter().Status();
  EXPECT_EQ(status.dropped_damaged, 2);
  EXPECT_THAT(status.text, HasSubstr(kIn));
  Send(2);
  Deliver();
  loop.HandleWaiting();
  Deliver();
  EXPECT_THAT(Numbers(results), ElementsAre(0, 2));
  EXPECT_EQ(loop.reporter().Status().lost_upstream, 0);
  EXPECT_EQ(loop.reporter().Status().state, service_status_t::RUNNING);
}

TEST_F(StageLoopTest, WhatAHandlerThrowsIsCountedAndSaid) {
  StageLoop loop(lcm_, Lossless());
  loop.Connect<fallen_persons_t, fallen_persons_t>(
      kIn, kOut, [](const fallen_persons_t& message) -> fallen_persons_t {
        if (message.header.seq == 1) throw std::invalid_argument("cell_size_m: got 1, expected 2");
        return message;
      });
  Collector<fallen_persons_t> results(lcm_, kOut);
  Send(0);
  Send(1);
  Deliver();
  loop.HandleWaiting();
  EXPECT_EQ(loop.reporter().Status().dropped_damaged, 1);
  EXPECT_EQ(loop.reporter().Status().state, service_status_t::DEGRADED);
  EXPECT_THAT(loop.reporter().Status().text, HasSubstr("cell_size_m: got 1, expected 2"));
  Send(2);
  Deliver();
  loop.HandleWaiting();
  Deliver();
  EXPECT_THAT(Numbers(results), ElementsAre(0, 2));
}

TEST_F(StageLoopTest, WorkerTakesItsShareAndCountsTheRest) {
  StageOptions options = Lossless();
  options.worker = {1, 3};
  StageLoop loop(lcm_, options);
  Echo(loop);
  Collector<fallen_persons_t> results(lcm_, kOut);
  for (int seq = 0; seq < 9; ++seq) Send(seq);
  Deliver();
  loop.HandleWaiting();
  Deliver();
  EXPECT_THAT(Numbers(results), ElementsAre(1, 4, 7));
  EXPECT_EQ(loop.reporter().Status().skipped, 6);
  EXPECT_EQ(loop.reporter().Status().lost_upstream, 0);
}

TEST_F(StageLoopTest, WorkerDoesNotLookIntoFramesOfOthers) {
  StageOptions options = Lossless();
  options.worker = {1, 3};
  StageLoop loop(lcm_, options);
  Echo(loop);
  for (int seq = 0; seq < 3; ++seq) {
    std::vector<std::uint8_t> bytes = EncodeMessage(FrameNumber(seq));
    bytes.pop_back();
    lcm_.publish(kIn, bytes.data(), static_cast<unsigned>(bytes.size()));
  }
  Deliver();
  EXPECT_EQ(loop.reporter().Status().skipped, 2);
  EXPECT_EQ(loop.reporter().Status().dropped_damaged, 1) << "its own";
}

TEST_F(StageLoopTest, LosslessQueueIsBoundedAndCountsWhatHadToGo) {
  StageOptions options = Lossless();
  options.max_waiting_bytes = 3 * static_cast<std::size_t>(FrameNumber(0).getEncodedSize());
  StageLoop loop(lcm_, options);
  Echo(loop);
  for (int seq = 0; seq < 10; ++seq) Send(seq);
  Deliver();
  EXPECT_EQ(loop.reporter().Status().dropped_late, 7);
}

TEST_F(StageLoopTest, SideInputsKeepTheirPlaceBetweenFrames) {
  StageLoop loop(lcm_, Lossless());
  std::vector<std::string> order;
  loop.OnFrame<fallen_persons_t>(kIn, [&](const fallen_persons_t& message) {
    order.push_back("frame " + std::to_string(message.header.seq));
  });
  loop.OnMessage<pose_t>(
      "POSE", [&](const pose_t& pose) { order.push_back("pose " + std::to_string(pose.utime)); });
  pose_t pose{};
  Send(0);
  pose.utime = 1;
  lcm_.publish("POSE", &pose);
  Send(2);
  Deliver();
  loop.HandleWaiting();
  EXPECT_THAT(order, ElementsAre("frame 0", "pose 1", "frame 2"));
  EXPECT_EQ(loop.reporter().Status().received, 2) << "poses are no frames";
}

TEST_F(StageLoopTest, StatusSaysWhoAndIsStartingBeforeTheFirstInput) {
  StageLoop loop(lcm_, Lossless());
  Echo(loop);
  Collector<service_status_t> statuses(lcm_, "STATUS_EXAMPLE");
  loop.reporter().PublishStatus();
  Send(3);
  Deliver();
  loop.HandleWaiting();
  loop.reporter().PublishStatus();
  Deliver();
  ASSERT_EQ(statuses.messages.size(), 2U);
  const service_status_t& first = statuses.messages[0];
  EXPECT_EQ(first.state, service_status_t::STARTING);
  EXPECT_EQ(first.service, "example");
  EXPECT_EQ(first.header.utime, 0);
  EXPECT_EQ(first.header.seq, 0);
  EXPECT_EQ(first.header.sensor_name, "CAMERA");
  EXPECT_GT(first.pid, 0);
  EXPECT_GT(first.resident_bytes, 1 << 20);
  const service_status_t& second = statuses.messages[1];
  EXPECT_EQ(second.state, service_status_t::RUNNING);
  EXPECT_EQ(second.header.utime, 3000);
  EXPECT_EQ(second.header.seq, 1);
  EXPECT_GT(second.rate_hz, 0);
}

TEST_F(StageLoopTest, RunHandlesPublishesStatusAndStopsOnRequest) {
  StageLoop loop(lcm_, Lossless());
  Echo(loop);
  Collector<fallen_persons_t> results(lcm_, kOut);
  Collector<service_status_t> statuses(lcm_, "STATUS_EXAMPLE");
  for (int seq = 0; seq < 20; ++seq) Send(seq);
  // Long enough for two statuses at 1 Hz, besides the one at the end.
  EXPECT_EQ(loop.Run(After(std::chrono::milliseconds(1200))), 0);
  Deliver();
  EXPECT_EQ(results.messages.size(), 20U);
  ASSERT_EQ(statuses.messages.size(), 3U);
  EXPECT_EQ(statuses.messages.back().state, service_status_t::STOPPING);
  EXPECT_EQ(statuses.messages.back().published, 20);
}

TEST_F(StageLoopTest, LosslessStopWorksOffWhatHasArrived) {
  StageLoop loop(lcm_, Lossless());
  std::atomic<int> handled = 0;
  loop.OnFrame<fallen_persons_t>(kIn, [&](const fallen_persons_t&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ++handled;
  });
  for (int seq = 0; seq < 30; ++seq) Send(seq);
  EXPECT_EQ(loop.Run([first = true]() mutable { return std::exchange(first, false); }), 0);
  EXPECT_EQ(handled, 30);
}

TEST_F(StageLoopTest, SecondStopAbandonsWhatWaits) {
  StageLoop loop(lcm_, Lossless());
  std::atomic<int> handled = 0;
  loop.OnFrame<fallen_persons_t>(kIn, [&](const fallen_persons_t&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ++handled;
  });
  for (int seq = 0; seq < 100; ++seq) Send(seq);
  EXPECT_EQ(loop.Run([] { return true; }), 0);
  EXPECT_LT(handled, 100);
}

TEST_F(StageLoopTest, IdleHandlerRunsOnceAfterTheLastInput) {
  StageLoop loop(lcm_, Live());
  std::atomic<int> idle = 0;
  loop.OnFrame<fallen_persons_t>(kIn, [](const fallen_persons_t&) {});
  loop.OnIdle([&] { ++idle; });
  Send(0);
  loop.Run(After(std::chrono::milliseconds(700)));  // three times the idle time
  EXPECT_EQ(idle, 1);
}

}  // namespace
}  // namespace fallen
