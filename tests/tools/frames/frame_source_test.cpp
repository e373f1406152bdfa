// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/frames/frame_source.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "fallen/messages/log_file.hpp"
#include "tests/tools/common/grey_png.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/tum_fixture.hpp"
#include "tools/import/import_log.hpp"

namespace fallen {
namespace {

using lying_scene::With;
using testing::HasSubstr;

std::vector<Frame> ReadAll(FrameSource& source) {
  std::vector<Frame> frames;
  while (std::optional<Frame> frame = source.Next()) frames.push_back(std::move(*frame));
  return frames;
}

StampedDepthImage Depth(std::int64_t utime, std::int64_t seq) {
  StampedDepthImage depth;
  depth.header = {utime, seq, "FRONT"};
  depth.image.intrinsics = {4, 2, 3, 3, 1.5, 0.5};
  depth.image.depth = {1, 2, 3, 4, 5, 6, 7, 8};
  return depth;
}

StampedPose PoseAt(std::int64_t utime, double x) {
  return {utime, {x, 0, 0}, Eigen::Quaterniond::Identity()};
}

/// Runs `write` on a new log; returns its path.
template <class Write>
std::filesystem::path MakeLog(const TemporaryFolder& folder, Write&& write) {
  const std::filesystem::path log = folder.path() / "test.lcm";
  LogWriter writer(log);
  write(writer);
  writer.Close();
  return log;
}

std::string OpeningError(const std::filesystem::path& input,
                         const std::optional<std::string>& camera = {}) {
  try {
    OpenFrameSource(input, camera);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(FrameSource, ADirectoryAndItsImportedLogGiveTheSameFramesBitForBit) {
  for (const bool with_poses : {true, false}) {
    const TemporaryFolder folder;
    lying_scene::WriteDirectory(folder.path(), 3, With::kPerson, with_poses);
    const auto log = folder.path() / "out.lcm";
    ImportDirectory(folder.path(), log, "CAMERA");
    const auto from_directory = OpenFrameSource(folder.path());
    const auto from_log = OpenFrameSource(log);
    const std::vector<Frame> a = ReadAll(*from_directory);
    const std::vector<Frame> b = ReadAll(*from_log);
    ASSERT_EQ(a.size(), 3u);
    ASSERT_EQ(b.size(), 3u);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].utime, b[i].utime);
      EXPECT_EQ(a[i].seq, b[i].seq);
      EXPECT_EQ(a[i].sensor_name, b[i].sensor_name);
      EXPECT_EQ(a[i].image.depth, b[i].image.depth);
      ASSERT_EQ(a[i].T_world_robot.has_value(), with_poses);
      ASSERT_EQ(b[i].T_world_robot.has_value(), with_poses);
      if (!with_poses) continue;
      EXPECT_EQ(a[i].T_world_robot->matrix(), b[i].T_world_robot->matrix());
      EXPECT_EQ(a[i].T_robot_camera->matrix(), b[i].T_robot_camera->matrix());
    }
    EXPECT_EQ(from_log->share_done(), 1);
    EXPECT_EQ(from_directory->share_done(), 1);
  }
}

TEST(FrameSource, JoinsFramesOfALogWithThePosesAroundThem) {
  const TemporaryFolder folder;
  const auto log = MakeLog(folder, [](LogWriter& writer) {
    writer.Write(0, "ROBOT_POSE", EncodeMessage(ToMessage(PoseAt(1'000'000, 1))));
    writer.Write(1, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(1'040'000, 7))));
    writer.Write(2, "OTHER", {1, 2, 3});
    writer.Write(3, "ROBOT_POSE", EncodeMessage(ToMessage(PoseAt(1'100'000, 2))));
    writer.Write(4, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(1'120'000, 8))));
  });
  const auto source = OpenFrameSource(log);
  EXPECT_EQ(source->camera(), "FRONT");
  const std::vector<Frame> frames = ReadAll(*source);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].seq, 7);
  EXPECT_EQ(frames[0].image.depth, Depth(0, 0).image.depth);
  ASSERT_TRUE(frames[0].T_world_robot);
  EXPECT_NEAR(frames[0].T_world_robot->translation().x(), 1.4, 1e-9);
  EXPECT_TRUE(frames[1].T_world_robot) << "flushed at the end, 20 ms beyond the newest pose";
  EXPECT_EQ(source->damage().count, 0);
}

TEST(FrameSource, FindsGroundTruthWhereverItStandsInALog) {
  const TemporaryFolder folder;
  GroundTruth truth;
  truth.person_box = OrientedBox{{1, 2, 0.2}, {2, 1, 0.4}, 0.5};
  const auto log = MakeLog(folder, [&](LogWriter& writer) {
    writer.Write(0, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(10, 0))));
    writer.Write(0, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(20, 1))));
    writer.Write(0, "GROUND_TRUTH_FRONT", EncodeMessage(ToMessage({10, 0, "FRONT"}, truth)));
    writer.Write(0, "GROUND_TRUTH_BACK", EncodeMessage(ToMessage({20, 1, "BACK"}, truth)));
  });
  const auto source = OpenFrameSource(log);
  const std::vector<Frame> frames = ReadAll(*source);
  ASSERT_TRUE(source->Truth(frames.at(0)));
  EXPECT_EQ(source->Truth(frames[0])->person_box, truth.person_box);
  EXPECT_FALSE(source->Truth(frames.at(1))) << "that of another camera";
}

TEST(FrameSource, CountsWhatIsDamagedAndGoesOn) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> cut = EncodeMessage(ToMessage(Depth(20, 1)));
  cut.resize(cut.size() / 2);
  const auto log = MakeLog(folder, [&](LogWriter& writer) {
    writer.Write(0, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(10, 0))));
    writer.Write(0, "DEPTH_FRONT", cut);
    writer.Write(0, "ROBOT_POSE", {});
    writer.Write(0, "DEPTH_FRONT", EncodeMessage(ToMessage(Depth(30, 2))));
  });
  const auto source = OpenFrameSource(log);
  EXPECT_EQ(ReadAll(*source).size(), 2u);
  EXPECT_EQ(source->damage().count, 2);
  EXPECT_FALSE(source->damage().example.empty());

  const TumFixture fixture(3);
  WriteGreyPng(fixture.path() / "depth/1.png", 8, 6, TumFixture::Values(1), {.bit_depth = 8});
  const auto directory = OpenFrameSource(fixture.path());
  const std::vector<Frame> frames = ReadAll(*directory);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].seq, 2) << "numbers are those of depth.txt";
  EXPECT_EQ(directory->damage().count, 1);
  EXPECT_THAT(directory->damage().example, HasSubstr("1.png"));
}

TEST(FrameSource, ChoosesAmongCameras) {
  const TemporaryFolder folder;
  const auto log = MakeLog(folder, [](LogWriter& writer) {
    for (const char* channel : {"DEPTH_FRONT", "DEPTH_BACK", "DEPTH_BACK"})
      writer.Write(0, channel, EncodeMessage(ToMessage(Depth(10, 0))));
  });
  EXPECT_THAT(OpeningError(log), testing::AllOf(HasSubstr("FRONT"), HasSubstr("BACK")));
  EXPECT_THAT(OpeningError(log, "SIDE"), HasSubstr("SIDE"));
  const auto source = OpenFrameSource(log, "BACK");
  EXPECT_EQ(ReadAll(*source).size(), 2u);
}

TEST(FrameSource, RefusesWhatIsNoRecording) {
  const TemporaryFolder folder;
  EXPECT_THAT(OpeningError(folder.path() / "missing.lcm"), HasSubstr("no such file"));
  EXPECT_THAT(OpeningError(folder.path()), HasSubstr("camera.yaml"));
  EXPECT_THAT(OpeningError(folder.Write("text.lcm", "no log at all")), HasSubstr("text.lcm"));
  EXPECT_THAT(OpeningError(folder.Write("empty.lcm", "")), HasSubstr("empty.lcm"));
  EXPECT_THAT(OpeningError(folder.Write("bad.oni", "NI10 but no more")), HasSubstr("bad.oni"));
}

}  // namespace
}  // namespace fallen
