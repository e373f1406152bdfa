// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/import_log.hpp"

#include <gmock/gmock.h>

#include "fallen/messages/log_file.hpp"
#include "tests/tools/common/tum_fixture.hpp"
#include "tools/import/tum_directory.hpp"

namespace fallen {
namespace {

using testing::ElementsAre;

std::vector<LogEvent> ReadEvents(const std::filesystem::path& log) {
  LogReader reader(log);
  std::vector<LogEvent> events;
  while (std::optional<LogEvent> event = reader.Next()) events.push_back(std::move(*event));
  EXPECT_TRUE(reader.damage().empty());
  return events;
}

template <class Message>
Message Decode(const LogEvent& event) {
  Message message{};
  EXPECT_GE(message.decode(event.data.data(), 0, static_cast<int>(event.data.size())), 0);
  return message;
}

TEST(ImportDirectory, WritesPoseThenTruthThenDepthAtTheImagesTime) {
  TumFixture fixture(2);
  fixture.Write("groundtruth.txt", "0.1 3 4 1.2 -0.5 0.5 -0.5 0.5\n");
  fixture.Write("labels.yaml",
                "person: {present: true, box: {center: [1, 2, 0.2], size: [2, 1, 0.4], yaw: 1}}\n");
  const auto log = fixture.path() / "out.lcm";
  const ImportReport report = ImportDirectory(fixture.path(), log, "FRONT");
  EXPECT_EQ(report.frames, 2);
  EXPECT_EQ(report.labelled, 2);

  std::vector<std::string> channels;
  const std::vector<LogEvent> events = ReadEvents(log);
  for (const LogEvent& event : events) channels.push_back(event.channel);
  // 0.1 s behind the pose is as far as the newest pose speaks.
  ASSERT_THAT(channels, ElementsAre("ROBOT_POSE", "GROUND_TRUTH_FRONT", "DEPTH_FRONT", "ROBOT_POSE",
                                    "GROUND_TRUTH_FRONT", "DEPTH_FRONT"));
  EXPECT_EQ(events[2].utime, 100000);

  const pose_t pose = Decode<pose_t>(events[0]);
  EXPECT_EQ(pose.utime, 100000);
  EXPECT_NEAR(pose.pos[0], 3, 1e-12);
  EXPECT_NEAR(pose.pos[1], 4, 1e-12);
  EXPECT_EQ(pose.pos[2], 0);

  const GroundTruth truth = FromMessage(Decode<ground_truth_t>(events[1]));
  ASSERT_TRUE(truth.person_box);
  EXPECT_EQ(*truth.person_box, (OrientedBox{{1, 2, 0.2}, {2, 1, 0.4}, 1}));

  const StampedDepthImage depth = FromMessage(Decode<depth_image_t>(events[5]));
  EXPECT_EQ(depth.header, (Header{200000, 1, "FRONT"}));
  EXPECT_EQ(depth.image.depth, TumFixture::Values(1));
  EXPECT_EQ(depth.image.depth_unit_m, 0.001);
  ASSERT_TRUE(depth.T_robot_camera);
  EXPECT_NEAR(depth.T_robot_camera->translation().z(), 1.2, 1e-9);
}

TEST(ImportDirectory, PoseTimesMountingIsTheCamerasPose) {
  TumFixture fixture(1);
  fixture.Write("groundtruth.txt",
                "0.1 -0.337698 0.257545 1.379581 -0.832402 -0.20782 0.056243 "
                "0.510641\n");
  const auto log = fixture.path() / "out.lcm";
  ImportDirectory(fixture.path(), log, "CAMERA");
  const std::vector<LogEvent> events = ReadEvents(log);
  const StampedPose pose = FromMessage(Decode<pose_t>(events.at(0)));
  const StampedDepthImage depth = FromMessage(Decode<depth_image_t>(events.at(1)));

  const Eigen::Isometry3d T_world_camera =
      Eigen::Translation3d(pose.translation) * pose.rotation * *depth.T_robot_camera;
  const Eigen::Quaterniond expected =
      Eigen::Quaterniond(0.510641, -0.832402, -0.20782, 0.056243).normalized();
  EXPECT_TRUE(
      T_world_camera.translation().isApprox(Eigen::Vector3d(-0.337698, 0.257545, 1.379581), 1e-9));
  EXPECT_TRUE(T_world_camera.linear().isApprox(expected.toRotationMatrix(), 1e-9));
}

TEST(ImportDirectory, WritesDepthAloneWhereNothingElseIsKnown) {
  const TumFixture fixture(2);
  const auto log = fixture.path() / "out.lcm";
  const ImportReport report = ImportDirectory(fixture.path(), log, "CAMERA");
  EXPECT_EQ(report.poses, 0);
  const std::vector<LogEvent> events = ReadEvents(log);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_FALSE(FromMessage(Decode<depth_image_t>(events[0])).T_robot_camera);
}

TEST(ImportDirectory, LeavesNoHalfLogBehind) {
  const TumFixture fixture(2);
  const TemporaryFolder output;
  WriteGreyPng(fixture.path() / "depth/1.png", 8, 6, TumFixture::Values(1), {.bit_depth = 8});
  EXPECT_THROW(ImportDirectory(fixture.path(), output.path() / "out.lcm", "CAMERA"),
               std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(output.path()));
}

TEST(ImportDirectory, TakesTheRealRecordings) {
  struct Real {
    const char* name;
    std::int64_t frames;
    std::int64_t poses;
  };
  for (const Real& real : {Real{"urfd-fall-01", 98, 0}, Real{"7-scenes-kitchen", 100, 100},
                           Real{"pcl-office", 4, 0}}) {
    const std::filesystem::path directory =
        std::filesystem::path(FALLEN_SOURCE_DIR "/../shared/real") / real.name;
    if (!std::filesystem::exists(directory)) GTEST_SKIP() << directory << " is not here";
    const TemporaryFolder output;
    const auto log = output.path() / "out.lcm";
    const ImportReport report = ImportDirectory(directory, log, "CAMERA");
    EXPECT_EQ(report.frames, real.frames);
    EXPECT_EQ(report.poses, real.poses);
    EXPECT_EQ(report.labelled, real.frames);

    // What stands in the log is what stands in the picture.
    const TumDirectory source = ReadTumDirectory(directory);
    std::size_t index = 0;
    for (const LogEvent& event : ReadEvents(log)) {
      if (event.channel != "DEPTH_CAMERA") continue;
      const StampedDepthImage depth = FromMessage(Decode<depth_image_t>(event));
      ASSERT_EQ(depth.image.depth, LoadTumFrame(source, index, "CAMERA").depth.image.depth);
      index += 1;
    }
    EXPECT_EQ(index, static_cast<std::size_t>(real.frames));
  }
}

}  // namespace
}  // namespace fallen
