// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "fallen/messages/message_inspection.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

class RecordingTest : public testing::Test {
 protected:
  RecordingTest()
      : path_(std::filesystem::path(testing::TempDir()) /
              (std::string("recording_test_") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + ".lcm")) {}
  ~RecordingTest() override { std::filesystem::remove(path_); }

  static std::vector<std::uint8_t> Image(std::int64_t seq) {
    StampedDepthImage image = samples::SampleDepthImage();
    image.header.seq = seq;
    return EncodeMessage(ToMessage(image));
  }
  static std::vector<std::uint8_t> Truth(std::int64_t seq) {
    return EncodeMessage(ToMessage(Header{5, seq, "FRONT"}, samples::SampleTruth()));
  }
  static std::vector<std::uint8_t> Pose() { return EncodeMessage(samples::SamplePose()); }

  std::string ErrorOf(const std::string& camera) const {
    try {
      Recording recording(path_, camera);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path path_;
};

TEST_F(RecordingTest, GivesInputsInTheOrderOfTheLog) {
  LogWriter writer(path_);
  writer.Write(1, "ROBOT_POSE", Pose());
  writer.Write(2, "GROUND_TRUTH_FRONT", Truth(0));
  writer.Write(3, "DEPTH_FRONT", Image(0));
  writer.Write(4, "SOMETHING_ELSE", {1, 2, 3});
  writer.Write(5, "DEPTH_FRONT", Image(1));
  writer.Close();

  Recording recording(path_);
  EXPECT_EQ(recording.camera(), "FRONT");
  EXPECT_EQ(std::get<StampedPose>(*recording.Next()).translation, Eigen::Vector3d(1.1, -2.2, 3.3));
  const auto truth = std::get<RecordedTruth>(*recording.Next());
  EXPECT_EQ(truth.header, (Header{5, 0, "FRONT"}));
  EXPECT_EQ(truth.truth.labels, samples::SampleTruth().labels);
  EXPECT_EQ(std::get<StampedDepthImage>(*recording.Next()).image.depth,
            samples::SampleDepthImage().image.depth);
  EXPECT_EQ(std::get<StampedDepthImage>(*recording.Next()).header.seq, 1);
  EXPECT_FALSE(recording.Next());
  EXPECT_FALSE(recording.Next());
  EXPECT_EQ(recording.progress(), 1);
  EXPECT_EQ(recording.counts().images, 2);
  EXPECT_EQ(recording.counts().poses, 1);
  EXPECT_EQ(recording.counts().truths, 1);
  EXPECT_EQ(recording.counts().refused, 0);
  EXPECT_EQ(recording.counts().newest_problem, "");
}

TEST_F(RecordingTest, SeveralCamerasMustBeChosenFrom) {
  LogWriter writer(path_);
  writer.Write(1, "DEPTH_REAR", Image(7));
  writer.Write(2, "GROUND_TRUTH_REAR", Truth(7));
  writer.Write(3, "DEPTH_FRONT", Image(8));
  writer.Write(4, "DEPTH_SETTINGS", {1, 2, 3, 4, 5, 6, 7, 8, 9});  // no image
  writer.Close();

  EXPECT_THAT(CamerasIn(path_), testing::ElementsAre("FRONT", "REAR"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("camera: got none, expected one of FRONT, REAR"));
  EXPECT_THAT(ErrorOf("LEFT"), HasSubstr("camera: got LEFT, expected one of FRONT, REAR"));
  Recording front(path_, "FRONT");
  EXPECT_EQ(std::get<StampedDepthImage>(*front.Next()).header.seq, 8);
  EXPECT_FALSE(front.Next());
}

TEST_F(RecordingTest, ALogWithoutImagesIsRefused) {
  LogWriter writer(path_);
  writer.Write(1, "ROBOT_POSE", Pose());
  writer.Close();
  EXPECT_THAT(ErrorOf(""), HasSubstr("got no depth images, expected DEPTH_<CAMERA>"));
  EXPECT_THAT(ErrorOf("FRONT"), HasSubstr("got no depth images, expected DEPTH_FRONT"));
  EXPECT_THROW(Recording("/nowhere.lcm"), std::runtime_error);
}

TEST_F(RecordingTest, WhatIsDamagedIsLeftOutAndCounted) {
  {
    LogWriter writer(path_);
    writer.Write(1, "DEPTH_FRONT", Image(0));
    auto truncated = Image(1);
    truncated.resize(truncated.size() - 5);
    writer.Write(2, "DEPTH_FRONT", truncated);
    auto nonsense = samples::SamplePose();
    nonsense.orientation[0] = 9;
    writer.Write(3, "ROBOT_POSE", EncodeMessage(nonsense));
    writer.Write(4, "GROUND_TRUTH_FRONT", Image(3));  // another type
    writer.Write(5, "DEPTH_FRONT", Image(2));
    writer.Close();
    std::ofstream(path_, std::ios::app | std::ios::binary) << "garbage";
  }
  Recording recording(path_);
  EXPECT_EQ(std::get<StampedDepthImage>(*recording.Next()).header.seq, 0);
  EXPECT_EQ(std::get<StampedDepthImage>(*recording.Next()).header.seq, 2);
  EXPECT_EQ(recording.counts().refused, 3);
  EXPECT_THAT(recording.counts().newest_problem,
              HasSubstr("GROUND_TRUTH_FRONT: ground_truth_t: got a message of another type"));
  EXPECT_FALSE(recording.Next());
  EXPECT_EQ(recording.counts().damaged_places, 1);
  EXPECT_EQ(recording.counts().damaged_bytes, 7);
  EXPECT_THAT(recording.counts().newest_problem, HasSubstr("offset "));
  EXPECT_EQ(recording.counts().images, 2);
  EXPECT_EQ(recording.counts().poses, 0);
}

TEST(InspectMessage, TellsTypeAndHeader) {
  const auto image = InspectMessage(EncodeMessage(ToMessage(samples::SampleDepthImage())));
  EXPECT_EQ(image.type, "depth_image_t");
  EXPECT_EQ(image.error, "");
  EXPECT_EQ(image.header, samples::SampleHeader());
  const auto map =
      InspectMessage(EncodeMessage(ToMessage(samples::SampleHeader(), samples::SampleMap())));
  EXPECT_EQ(map.type, "ndt_map_t");
  EXPECT_EQ(map.error, "");
  const auto pose = InspectMessage(EncodeMessage(samples::SamplePose()));
  EXPECT_EQ(pose.type, "pose_t");
  EXPECT_FALSE(pose.header);
  const auto status = InspectMessage(EncodeMessage(samples::SampleStatus()));
  EXPECT_EQ(status.type, "service_status_t");
  EXPECT_EQ(status.error, "");
}

TEST(InspectMessage, TellsWhatIsWrong) {
  EXPECT_EQ(InspectMessage({}).type, "");
  const std::vector<std::uint8_t> foreign = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(InspectMessage(foreign).type, "");
  EXPECT_EQ(InspectMessage(foreign).hash, 0x0102030405060708u);
  EXPECT_EQ(InspectMessage(foreign).error, "");

  auto message = samples::SamplePose();
  message.pos[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(InspectMessage(EncodeMessage(message)).type, "pose_t");
  EXPECT_THAT(InspectMessage(EncodeMessage(message)).error, HasSubstr("pose_t.pos: got nan"));
  auto bytes = EncodeMessage(samples::SamplePose());
  bytes.pop_back();
  EXPECT_THAT(InspectMessage(bytes).error, HasSubstr("pose_t.accel"));
}

}  // namespace
}  // namespace fallen
