// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Damaged messages, thousands of them, through the whole of each handler.
#include <gtest/gtest.h>

#include <random>

#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"
#include "services/background_subtraction/background_subtraction_service.hpp"
#include "services/cell_segmentation/cell_segmentation_service.hpp"
#include "services/cluster_classification/cluster_classification_service.hpp"
#include "services/ndt_mapping/ndt_mapping_service.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/synthetic_model.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen {
namespace {

using testing_support::MemqLink;
using testing_support::SceneImage;
using testing_support::ScenePose;
using testing_support::SyntheticModel;
using Bytes = std::vector<std::uint8_t>;

constexpr int kRounds = 1000;
constexpr std::size_t kHashBytes = 8;  // another type than expected is refused at once

/// Overwrites some bytes behind the hash; most messages stay whole on the wire.
Bytes Damaged(Bytes bytes, std::mt19937& random) {
  for (auto places = 1 + random() % 4; places > 0; --places) {
    const std::size_t place = kHashBytes + random() % (bytes.size() - kHashBytes);
    bytes[place] = static_cast<std::uint8_t>(random());
  }
  if (random() % 16 == 0) bytes.resize(kHashBytes + random() % (bytes.size() - kHashBytes));
  return bytes;
}

/// The scene, every `step`th pixel of every `step`th row: small messages, and quick stages.
StampedDepthImage SmallImage(int step = 4) {
  const StampedDepthImage full = SceneImage(0);
  const CameraIntrinsics& from = full.image.intrinsics;
  StampedDepthImage small = full;
  CameraIntrinsics& to = small.image.intrinsics;
  to = {from.width / step, from.height / step, from.fx / step,
        from.fy / step,    from.cx / step,     from.cy / step};
  small.image.depth.clear();
  for (int v = 0; v < to.height; ++v)
    for (int u = 0; u < to.width; ++u)
      small.image.depth.push_back(
          full.image.depth[static_cast<std::size_t>(v * step * from.width + u * step)]);
  return small;
}

ForegroundMap SmallForeground(int step = 4) {
  const StampedDepthImage image = SmallImage(step);
  return BackgroundSubtractor().Subtract(
      NdtMapper().Update(image.header.utime, image.image, std::nullopt,
                         EstimateGround(image.image, image.T_robot_camera)));
}

class HostileMessages : public testing::Test {
 protected:
  /// Sends damaged copies of `good` and after each lets the service work.
  /// @return How many messages it has answered.
  std::size_t SendDamaged(StageLoop& loop, const std::string& channel, const Bytes& good) {
    // Other damage: --gtest_shuffle --gtest_random_seed=N.
    std::mt19937 random(1 + static_cast<unsigned>(testing::UnitTest::GetInstance()->random_seed()));
    const std::size_t before = link_.answers().size();
    for (int round = 0; round < kRounds; ++round) {
      link_.Send(channel, Damaged(good, random));
      EXPECT_NO_THROW(link_.Exchange(loop));
    }
    return link_.answers().size() - before;
  }

  /// Every damaged message is either answered or counted, some are one and some the other, and a
  /// good one afterwards gets the answer that it got before.
  void ExpectEachAnsweredOrCounted(StageLoop& loop, const std::string& in, const std::string& out,
                                   const Bytes& good) {
    link_.Collect(out);
    link_.Send(in, good);
    link_.Exchange(loop);
    const std::size_t answered = SendDamaged(loop, in, good);
    const auto counted = static_cast<std::size_t>(loop.reporter().Status().dropped_damaged);
    EXPECT_EQ(answered + counted, static_cast<std::size_t>(kRounds));
    EXPECT_GT(answered, 0U);
    EXPECT_GT(counted, 0U);
    link_.Send(in, good);
    link_.Exchange(loop);
    EXPECT_EQ(link_.answers().back(), link_.answers().front());
  }

  MemqLink link_;
  const Header header_{1'234'567, 42, "CAMERA"};
};

TEST_F(HostileMessages, ToTheMapping) {
  NdtMappingService service(link_.lcm(), MemqLink::Options("ndt-mapping"), GroundConfig{},
                            NdtConfig{});
  link_.Collect(channels::NdtMap("CAMERA"));
  const StampedDepthImage image = SmallImage();
  SendDamaged(service.loop(), channels::kRobotPose,
              EncodeMessage(ToMessage(ScenePose(image.header.utime))));
  SendDamaged(service.loop(), channels::Depth("CAMERA"), EncodeMessage(ToMessage(image)));
  EXPECT_GT(service.loop().reporter().Status().dropped_damaged, 0);
  EXPECT_FALSE(link_.answers().empty());
  for (const Bytes& answer : link_.answers()) {
    const Decoded<ndt_map_t> map = DecodeMessage<ndt_map_t>(answer);
    ASSERT_TRUE(map) << map.error;
    EXPECT_NO_THROW(NdtMapFromMessage(*map.message));
  }
}

TEST_F(HostileMessages, ToTheBackgroundSubtraction) {
  const ForegroundMap foreground = SmallForeground();
  EnvironmentMap environment{foreground.map.cell_size_m, foreground.map.cells};
  BackgroundSubtractionService service(link_.lcm(), MemqLink::Options("background-subtraction"),
                                       BackgroundSubtractor(environment));
  NdtMap map = foreground.map;
  map.frame = MapFrame::kWorld;
  ExpectEachAnsweredOrCounted(service.loop(), channels::NdtMap("CAMERA"),
                              channels::Foreground("CAMERA"),
                              EncodeMessage(ToMessage(header_, map)));
}

TEST_F(HostileMessages, ToTheCellSegmentation) {
  const Model model = SyntheticModel();
  CellSegmentationService service(link_.lcm(), MemqLink::Options("cell-segmentation"), model.cells,
                                  model.segmentation);
  ExpectEachAnsweredOrCounted(service.loop(), channels::Foreground("CAMERA"),
                              channels::Clusters("CAMERA"),
                              EncodeMessage(ToMessage(header_, SmallForeground())));
}

TEST_F(HostileMessages, ToTheClusterClassification) {
  const Model model = SyntheticModel();
  ClusterClassificationService service(link_.lcm(), MemqLink::Options("cluster-classification"),
                                       model.clusters, ClassificationConfig{});
  const SegmentedMap segmented = SegmentCells(SmallForeground(2), model.cells, model.segmentation);
  ASSERT_FALSE(segmented.clusters.empty());
  ExpectEachAnsweredOrCounted(service.loop(), channels::Clusters("CAMERA"),
                              channels::FallenPersons("CAMERA"),
                              EncodeMessage(ToMessage(header_, segmented)));
}

}  // namespace
}  // namespace fallen
