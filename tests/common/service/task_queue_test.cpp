// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/task_queue.hpp"

#include <gmock/gmock.h>

#include <string>
#include <thread>
#include <vector>

namespace fallen {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

constexpr std::size_t kBytes = 10;

class TaskQueueTest : public testing::Test {
 protected:
  TaskQueue::Task Frame(const std::string& name) {
    return {[this, name] { done_.push_back(name); }, kBytes, true};
  }
  TaskQueue::Task Pose(const std::string& name) {
    return {[this, name] { done_.push_back(name); }, kBytes, false};
  }
  void WorkOff(TaskQueue& queue) {
    while (const auto task = queue.Pop(milliseconds(0))) task->work();
  }
  std::vector<std::string> done_;
};

TEST_F(TaskQueueTest, LiveOnlyTheNewestFrameWaitsAndPosesKeepTheirPlace) {
  TaskQueue queue(TaskQueue::Order::kNewestFrame, 1000);
  queue.Push(Pose("pose 1"));
  EXPECT_EQ(queue.Push(Frame("frame 1")).dropped_frames, 0);
  queue.Push(Pose("pose 2"));
  EXPECT_EQ(queue.Push(Frame("frame 2")).dropped_frames, 1);
  queue.Push(Pose("pose 3"));
  WorkOff(queue);
  EXPECT_THAT(done_, ElementsAre("pose 1", "pose 2", "frame 2", "pose 3"));
}

TEST_F(TaskQueueTest, LosslessEveryFrameWaitsInOrder) {
  TaskQueue queue(TaskQueue::Order::kEveryFrame, 1000);
  for (const char* name : {"1", "2", "3"}) EXPECT_EQ(queue.Push(Frame(name)).dropped_frames, 0);
  WorkOff(queue);
  EXPECT_THAT(done_, ElementsAre("1", "2", "3"));
}

TEST_F(TaskQueueTest, WhatDoesNotFitIsRefusedAndCounted) {
  TaskQueue queue(TaskQueue::Order::kEveryFrame, 2 * kBytes);
  queue.Push(Frame("1"));
  queue.Push(Frame("2"));
  const TaskQueue::Pushed third = queue.Push(Frame("3"));
  EXPECT_TRUE(third.refused);
  EXPECT_EQ(third.dropped_frames, 1);
  EXPECT_TRUE(queue.Push(Pose("pose")).refused);
  queue.Pop(milliseconds(0))->work();
  EXPECT_FALSE(queue.Push(Frame("4")).refused);
  WorkOff(queue);
  EXPECT_THAT(done_, ElementsAre("1", "2", "4"));
}

TEST_F(TaskQueueTest, LosslessCloseStillHandsOutWhatWaits) {
  TaskQueue queue(TaskQueue::Order::kEveryFrame, 1000);
  queue.Push(Frame("1"));
  queue.Close();
  EXPECT_FALSE(queue.is_finished());
  EXPECT_EQ(queue.Push(Frame("2")).dropped_frames, 1);
  WorkOff(queue);
  EXPECT_TRUE(queue.is_finished());
  EXPECT_THAT(done_, ElementsAre("1"));
}

TEST_F(TaskQueueTest, LiveCloseAndAbandonHandOutNothing) {
  TaskQueue live(TaskQueue::Order::kNewestFrame, 1000);
  live.Push(Frame("1"));
  live.Close();
  EXPECT_TRUE(live.is_finished());
  TaskQueue lossless(TaskQueue::Order::kEveryFrame, 1000);
  lossless.Push(Frame("1"));
  lossless.Abandon();
  EXPECT_TRUE(lossless.is_finished());
}

TEST_F(TaskQueueTest, CloseWakesWhoWaits) {
  TaskQueue queue(TaskQueue::Order::kEveryFrame, 1000);
  std::thread worker([&] { EXPECT_FALSE(queue.Pop(milliseconds(60000))); });
  queue.Close();
  worker.join();
}

}  // namespace
}  // namespace fallen
