// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/ndt_mapping/ndt_mapping_service.hpp"

#include <gmock/gmock.h>

#include "fallen/detection/map_update.hpp"
#include "fallen/messages/conversions.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing_support::MemqLink;
using testing_support::SceneImage;
using testing_support::ScenePose;

class NdtMappingServiceTest : public testing::Test {
 protected:
  NdtMappingServiceTest()
      : service_(link_.lcm(), MemqLink::Options("ndt-mapping"), GroundConfig{}, NdtConfig{}) {
    link_.Collect("NDT_MAP_CAMERA");
  }
  NdtMap Answer(std::size_t i) {
    return NdtMapFromMessage(DecodeMessage<ndt_map_t>(link_.answers().at(i)).message.value());
  }
  void SendPose(std::int64_t utime) {
    link_.SendMessage("ROBOT_POSE", ToMessage(ScenePose(utime)));
  }

  MemqLink link_;
  NdtMappingService service_;
};

TEST_F(NdtMappingServiceTest, FrameWaitsForThePoseAfterItAndIsMappedInTheWorld) {
  const StampedDepthImage image = SceneImage(3);
  SendPose(image.header.utime - 10'000);
  link_.SendMessage("DEPTH_CAMERA", ToMessage(image));
  link_.Exchange(service_.loop());
  EXPECT_TRUE(link_.answers().empty()) << "the pose after the frame is not there yet";
  SendPose(image.header.utime + 10'000);
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  const ndt_map_t message = DecodeMessage<ndt_map_t>(link_.answers()[0]).message.value();
  EXPECT_EQ(FromMessage(message.header), image.header);
  const NdtMap map = Answer(0);
  EXPECT_EQ(map.frame, MapFrame::kWorld);
  ASSERT_TRUE(map.ground.ok());
  EXPECT_GT(map.cells.size(), 50U);
  for (const NdtCell& cell : map.cells) {
    // The body's ellipsoid is all that stands on the floor: 2.1 to 2.7 m ahead, below 0.28 m.
    EXPECT_NEAR(cell.mean.x(), 2.4, 0.35);
    EXPECT_NEAR(cell.mean.z(), 0.14, 0.16);
  }
}

TEST_F(NdtMappingServiceTest, MapsAreThoseOfTheLibraryBitForBit) {
  NdtMapper mapper;
  std::vector<std::vector<std::uint8_t>> expected;
  for (int seq = 0; seq < 4; ++seq) {
    const StampedDepthImage image = SceneImage(seq);
    SendPose(image.header.utime);
    link_.SendMessage("DEPTH_CAMERA", ToMessage(image));

    // As it arrives: the mounting's rotation travels as a quaternion.
    const StampedDepthImage arrived = FromMessage(ToMessage(image));
    const StampedPose pose = FromMessage(ToMessage(ScenePose(image.header.utime)));
    Frame frame;
    frame.utime = image.header.utime;
    frame.image = arrived.image;
    frame.T_robot_camera = arrived.T_robot_camera;
    PoseBuffer poses;
    poses.Add(pose.utime, pose.translation, pose.rotation);
    frame.T_world_robot = poses.At(pose.utime);
    expected.push_back(
        EncodeMessage(ToMessage(image.header, UpdateMap(mapper, frame, GroundConfig{}))));
  }
  link_.Exchange(service_.loop());
  EXPECT_EQ(link_.answers(), expected);
}

TEST_F(NdtMappingServiceTest, WithoutAnyPoseFramesAreMappedAtOnceBelowTheCamera) {
  link_.SendMessage("DEPTH_CAMERA", ToMessage(SceneImage(0)));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_EQ(Answer(0).frame, MapFrame::kLevel);
}

TEST_F(NdtMappingServiceTest, NoFloorInViewIsAnOutcomeThatTheStatusTells) {
  StampedDepthImage image = SceneImage(0);
  image.T_robot_camera.reset();
  std::fill(image.image.depth.begin(), image.image.depth.end(), std::uint16_t{0});
  link_.SendMessage("DEPTH_CAMERA", ToMessage(image));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_FALSE(Answer(0).ground.ok());
  const service_status_t status = service_.loop().reporter().Status();
  EXPECT_EQ(status.state, service_status_t::DEGRADED);
  EXPECT_THAT(status.text, HasSubstr("ground: "));
}

TEST_F(NdtMappingServiceTest, BrokenMessagesAreCountedAndItGoesOn) {
  std::vector<std::uint8_t> broken = EncodeMessage(ToMessage(SceneImage(0)));
  broken.resize(broken.size() / 2);
  link_.Send("DEPTH_CAMERA", broken);
  depth_image_t nonsense = ToMessage(SceneImage(1));
  nonsense.fx = -1;
  link_.SendMessage("DEPTH_CAMERA", nonsense);
  pose_t pose = ToMessage(ScenePose(testing_support::kFirstUtime));
  pose.orientation[0] = 7;
  link_.SendMessage("ROBOT_POSE", pose);
  link_.Exchange(service_.loop());
  EXPECT_TRUE(link_.answers().empty());
  EXPECT_EQ(service_.loop().reporter().Status().dropped_damaged, 3);
  link_.SendMessage("DEPTH_CAMERA", ToMessage(SceneImage(2)));
  link_.Exchange(service_.loop());
  EXPECT_EQ(link_.answers().size(), 1U);
}

TEST_F(NdtMappingServiceTest, LastFrameOfAReplayComesWhenNothingFollows) {
  const StampedDepthImage image = SceneImage(3);
  SendPose(image.header.utime - 10'000);
  link_.SendMessage("DEPTH_CAMERA", ToMessage(image));
  const auto begin = std::chrono::steady_clock::now();
  service_.loop().Run(
      [&] { return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(300); });
  while (link_.lcm().handleTimeout(0) > 0) {
  }
  EXPECT_EQ(link_.answers().size(), 1U);
}

}  // namespace
}  // namespace fallen
