// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/cell_segmentation/cell_segmentation_service.hpp"

#include <gmock/gmock.h>

#include "fallen/messages/conversions.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/synthetic_model.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing_support::MemqLink;
using testing_support::SyntheticModel;

/// What the background subtraction would send for an image of the synthetic scene.
ForegroundMap SceneForeground(double cell_size_m = 0.05) {
  const StampedDepthImage image = testing_support::SceneImage(0);
  NdtConfig config;
  config.cell_size_m = cell_size_m;
  NdtMapper mapper(config);
  return BackgroundSubtractor().Subtract(
      mapper.Update(image.header.utime, image.image, std::nullopt,
                    EstimateGround(image.image, image.T_robot_camera)));
}

class CellSegmentationServiceTest : public testing::Test {
 protected:
  CellSegmentationServiceTest()
      : service_(link_.lcm(), MemqLink::Options("cell-segmentation"), SyntheticModel().cells,
                 SyntheticModel().segmentation) {
    link_.Collect("CLUSTERS_CAMERA");
  }

  MemqLink link_;
  CellSegmentationService service_;
  const Header header_{1'234'567, 42, "CAMERA"};
};

TEST_F(CellSegmentationServiceTest, ClustersAreThoseOfTheLibraryBitForBit) {
  const Model model = SyntheticModel();
  const ForegroundMap foreground = SceneForeground();
  const SegmentedMap segmented = SegmentCells(foreground, model.cells, model.segmentation);
  ASSERT_FALSE(segmented.clusters.empty()) << "the scene must have something to find";
  link_.SendMessage("FOREGROUND_CAMERA", ToMessage(header_, foreground));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_EQ(link_.answers()[0], EncodeMessage(ToMessage(header_, segmented)));
}

TEST_F(CellSegmentationServiceTest, MapOfAnotherCellSizeIsDroppedCountedAndSaid) {
  link_.SendMessage("FOREGROUND_CAMERA", ToMessage(header_, SceneForeground(0.1)));
  link_.Exchange(service_.loop());
  EXPECT_TRUE(link_.answers().empty());
  const service_status_t status = service_.loop().reporter().Status();
  EXPECT_EQ(status.dropped_damaged, 1);
  EXPECT_EQ(status.state, service_status_t::DEGRADED);
  EXPECT_THAT(status.text, HasSubstr("cell size"));
}

TEST_F(CellSegmentationServiceTest, BrokenMessagesAreCountedAndItGoesOn) {
  std::vector<std::uint8_t> broken = EncodeMessage(ToMessage(header_, SceneForeground()));
  broken.resize(broken.size() / 2);
  link_.Send("FOREGROUND_CAMERA", broken);
  link_.SendMessage("FOREGROUND_CAMERA", ToMessage(header_, SceneForeground().map));  // no flags
  link_.Exchange(service_.loop());
  EXPECT_TRUE(link_.answers().empty());
  EXPECT_EQ(service_.loop().reporter().Status().dropped_damaged, 2);
  link_.SendMessage("FOREGROUND_CAMERA", ToMessage(header_, SceneForeground()));
  link_.Exchange(service_.loop());
  EXPECT_EQ(link_.answers().size(), 1U);
}

TEST_F(CellSegmentationServiceTest, EmptyMapGivesAMessageWithoutClusters) {
  link_.SendMessage("FOREGROUND_CAMERA", ToMessage(header_, ForegroundMap{}));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  const clusters_t answer = DecodeMessage<clusters_t>(link_.answers()[0]).message.value();
  EXPECT_EQ(answer.cell_count, 0);
  EXPECT_EQ(FromMessage(answer.header), header_);
}

}  // namespace
}  // namespace fallen
