// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/pose_synchronizer.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace fallen {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t kMillisecond = 1000;

Frame FrameAt(std::int64_t utime) {
  Frame frame;
  frame.utime = utime;
  return frame;
}

/// A robot that drives along x at 1 m/s: x is the time.
std::vector<Frame> AddDrivingPose(PoseSynchronizer& synchronizer, std::int64_t utime) {
  return synchronizer.AddPose(utime, {static_cast<double>(utime) * 1e-6, 0, 0},
                              Eigen::Quaterniond::Identity());
}

std::vector<std::int64_t> Times(const std::vector<Frame>& frames) {
  std::vector<std::int64_t> times;
  for (const Frame& frame : frames) times.push_back(frame.utime);
  return times;
}

TEST(PoseSynchronizer, EmitsAtOnceAndWithoutPoseWhereNoPoseEverCame) {
  PoseSynchronizer synchronizer;
  const std::vector<Frame> frames = synchronizer.AddFrame(FrameAt(10 * kMillisecond));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_FALSE(frames[0].T_world_robot);
  EXPECT_EQ(synchronizer.waiting(), 0u);
}

TEST(PoseSynchronizer, EmitsAtOnceWithAPoseOfTheSameTime) {
  PoseSynchronizer synchronizer;
  EXPECT_THAT(AddDrivingPose(synchronizer, 2000 * kMillisecond), IsEmpty());
  const std::vector<Frame> frames = synchronizer.AddFrame(FrameAt(2000 * kMillisecond));
  ASSERT_EQ(frames.size(), 1u);
  ASSERT_TRUE(frames[0].T_world_robot);
  EXPECT_NEAR(frames[0].T_world_robot->translation().x(), 2.0, 1e-12);
}

TEST(PoseSynchronizer, WaitsForTheNextPoseAndInterpolates) {
  PoseSynchronizer synchronizer;
  AddDrivingPose(synchronizer, 1000 * kMillisecond);
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(1020 * kMillisecond)), IsEmpty());
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(1080 * kMillisecond)), IsEmpty());
  const std::vector<Frame> frames = AddDrivingPose(synchronizer, 1050 * kMillisecond);
  ASSERT_THAT(Times(frames), ElementsAre(1020 * kMillisecond));
  ASSERT_TRUE(frames[0].T_world_robot);
  EXPECT_NEAR(frames[0].T_world_robot->translation().x(), 1.02, 1e-9);
  EXPECT_EQ(synchronizer.waiting(), 1u);
}

TEST(PoseSynchronizer, StopsWaitingWhenLaterFramesShowThatTimeIsUp) {
  PoseSynchronizerConfig config;
  config.max_wait_s = 0.1;
  PoseSynchronizer synchronizer(config);
  AddDrivingPose(synchronizer, 1000 * kMillisecond);
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(1033 * kMillisecond)), IsEmpty());
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(1100 * kMillisecond)), IsEmpty());
  const std::vector<Frame> frames = synchronizer.AddFrame(FrameAt(1133 * kMillisecond));
  ASSERT_THAT(Times(frames), ElementsAre(1033 * kMillisecond));
  EXPECT_TRUE(frames[0].T_world_robot) << "33 ms beyond the newest pose is within reach";
}

TEST(PoseSynchronizer, NeverHoldsMoreFramesThanConfigured) {
  PoseSynchronizerConfig config;
  config.max_waiting_frames = 2;
  PoseSynchronizer synchronizer(config);
  AddDrivingPose(synchronizer, 0);
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(1)), IsEmpty());
  EXPECT_THAT(synchronizer.AddFrame(FrameAt(2)), IsEmpty());
  EXPECT_THAT(Times(synchronizer.AddFrame(FrameAt(3))), ElementsAre(1));
  EXPECT_EQ(synchronizer.waiting(), 2u);
}

TEST(PoseSynchronizer, DoesNotWaitForPosesThatHaveStopped) {
  PoseSynchronizer synchronizer;
  AddDrivingPose(synchronizer, 0);
  const std::vector<Frame> frames = synchronizer.AddFrame(FrameAt(2000 * kMillisecond));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_FALSE(frames[0].T_world_robot);
}

TEST(PoseSynchronizer, FlushEmitsTheRestInOrder) {
  PoseSynchronizer synchronizer;
  AddDrivingPose(synchronizer, 0);
  synchronizer.AddFrame(FrameAt(10));
  synchronizer.AddFrame(FrameAt(20));
  EXPECT_THAT(Times(synchronizer.Flush()), ElementsAre(10, 20));
  EXPECT_THAT(synchronizer.Flush(), IsEmpty());
}

TEST(PoseSynchronizer, ClockThatRunsBackReleasesWhoWaits) {
  PoseSynchronizer by_pose;
  AddDrivingPose(by_pose, 1000 * kMillisecond);
  by_pose.AddFrame(FrameAt(1010 * kMillisecond));
  const std::vector<Frame> released = AddDrivingPose(by_pose, 5 * kMillisecond);
  ASSERT_THAT(Times(released), ElementsAre(1010 * kMillisecond));
  EXPECT_TRUE(released[0].T_world_robot) << "judged by the poses of its own time";

  PoseSynchronizer by_frame;
  AddDrivingPose(by_frame, 1000 * kMillisecond);
  by_frame.AddFrame(FrameAt(1010 * kMillisecond));
  EXPECT_THAT(Times(by_frame.AddFrame(FrameAt(7))), ElementsAre(1010 * kMillisecond, 7));
}

TEST(PoseSynchronizer, CountsPosesThatAreNoPoses) {
  PoseSynchronizer synchronizer;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  synchronizer.AddPose(1, {nan, 0, 0}, Eigen::Quaterniond::Identity());
  synchronizer.AddPose(2, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0));
  EXPECT_EQ(synchronizer.refused_poses(), 2);
  EXPECT_EQ(synchronizer.AddFrame(FrameAt(3)).size(), 1u) << "still no pose has come";
}

TEST(PoseSynchronizer, ExtremeTimesDoNotOverflow) {
  PoseSynchronizer synchronizer;
  AddDrivingPose(synchronizer, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(synchronizer.AddFrame(FrameAt(std::numeric_limits<std::int64_t>::max())).size(), 1u);
}

TEST(PoseSynchronizer, RefusesAConfigurationOutOfRange) {
  PoseSynchronizerConfig config;
  config.max_wait_s = -1;
  EXPECT_THROW(PoseSynchronizer{config}, std::invalid_argument);
  config = {};
  config.max_gap_s = 0;
  EXPECT_THROW(PoseSynchronizer{config}, std::invalid_argument);
}

}  // namespace
}  // namespace fallen
