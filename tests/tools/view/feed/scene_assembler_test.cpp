// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/scene_assembler.hpp"

#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "fallen/messages/log_file.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::ElementsAre;

struct Collected {
  std::vector<std::int64_t> utimes;
  std::vector<Scene> scenes;
  SceneAssembler assembler{"CAMERA", [this](const Scene& scene) {
                             utimes.push_back(scene.header.utime);
                             scenes.push_back(scene);
                           }};

  template <class Message>
  void Take(const std::string& channel, const Message& message) {
    assembler.Take(channel, EncodeMessage(message));
  }
  void TakeDepth(std::int64_t utime) {
    StampedDepthImage image = testing_support::SceneImage(0);
    image.header.utime = utime;
    Take("DEPTH_CAMERA", ToMessage(image));
  }
  void TakeDecision(std::int64_t utime) {
    Take("FALLEN_PERSONS_CAMERA", ToMessage(Header{utime, 0, "CAMERA"}, Decision{}));
  }
};

TEST(SceneAssembler, JoinsWhatIsAboutTheSameFrame) {
  Collected collected;
  const Header header{1'000'000, 4, "CAMERA"};
  collected.TakeDepth(1'000'000);
  NdtMap map;
  collected.Take("NDT_MAP_CAMERA", ToMessage(header, map));
  collected.Take("CLUSTERS_CAMERA", ToMessage(header, SegmentedMap{}));
  EXPECT_TRUE(collected.scenes.empty()) << "not yet decided";
  collected.Take("FALLEN_PERSONS_CAMERA", ToMessage(header, Decision{}));
  ASSERT_EQ(collected.scenes.size(), 1u);
  const Scene& scene = collected.scenes[0];
  EXPECT_TRUE(scene.image && scene.map && scene.segmented && scene.decision);
}

TEST(SceneAssembler, IgnoresOtherCamerasAndChannels) {
  Collected collected;
  collected.Take("FALLEN_PERSONS_OTHER", ToMessage(Header{1, 0, "OTHER"}, Decision{}));
  collected.assembler.Take("ROBOT_POSE", std::vector<std::uint8_t>{1, 2, 3});
  EXPECT_TRUE(collected.scenes.empty());
}

TEST(SceneAssembler, GivesOutUndecidedFramesASecondLater) {
  Collected collected;
  for (int i = 0; i < 15; ++i) collected.TakeDepth(i * 100'000);
  EXPECT_THAT(collected.utimes, ElementsAre(0, 100'000, 200'000, 300'000));
  collected.assembler.Flush();
  EXPECT_EQ(collected.utimes.size(), 15u);
}

TEST(SceneAssembler, LeavesOutFramesThatANewerDecisionOvertook) {
  Collected collected;
  collected.TakeDepth(100'000);
  collected.TakeDecision(200'000);
  collected.TakeDecision(100'000);
  EXPECT_THAT(collected.utimes, ElementsAre(200'000));
}

TEST(SceneAssembler, BeginsAnewWhenALogIsStartedAgain) {
  Collected collected;
  collected.TakeDecision(9'000'000);
  collected.TakeDecision(1'000'000);
  EXPECT_THAT(collected.utimes, ElementsAre(9'000'000, 1'000'000));
}

TEST(SceneAssembler, RefusesDamagedMessages) {
  Collected collected;
  EXPECT_THROW(collected.assembler.Take("DEPTH_CAMERA", std::vector<std::uint8_t>(40, 7)),
               std::invalid_argument);
}

}  // namespace
}  // namespace fallen
