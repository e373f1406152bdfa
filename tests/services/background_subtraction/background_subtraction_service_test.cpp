// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/background_subtraction/background_subtraction_service.hpp"

#include <gmock/gmock.h>

#include "fallen/messages/conversions.hpp"
#include "tests/support/memq_service.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing_support::MemqLink;

/// A flat cell of the floor's orientation at `mean`.
NdtCell FlatCell(float x, float y, float z) {
  NdtCell cell;
  cell.mean = {x, y, z};
  cell.covariance = {2e-4F, 0, 0, 2e-4F, 0, 1e-6F};
  cell.point_count = 10;
  return cell;
}

NdtMap LocalMap(double cell_size_m = 0.05) {
  NdtMap map;
  map.cell_size_m = cell_size_m;
  map.frame = MapFrame::kWorld;
  map.ground.status = GroundStatus::kOk;
  map.cells = {FlatCell(1, 0, 0.7F), FlatCell(1.5F, 0, 0.2F)};
  return map;
}

EnvironmentMap TableOnly() { return {0.05, {FlatCell(1.01F, 0, 0.7F)}}; }

class BackgroundSubtractionServiceTest : public testing::Test {
 protected:
  BackgroundSubtractionServiceTest() { link_.Collect("FOREGROUND_CAMERA"); }

  ndt_map_t Answer(std::size_t i) {
    return DecodeMessage<ndt_map_t>(link_.answers().at(i)).message.value();
  }

  MemqLink link_;
  const Header header_{1'234'567, 42, "CAMERA"};
};

TEST_F(BackgroundSubtractionServiceTest, FlagsWhatTheEnvironmentMapDoesNotKnow) {
  BackgroundSubtractionService service(link_.lcm(), MemqLink::Options("background-subtraction"),
                                       BackgroundSubtractor(TableOnly()));
  link_.SendMessage("NDT_MAP_CAMERA", ToMessage(header_, LocalMap()));
  link_.Exchange(service.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  const ndt_map_t answer = Answer(0);
  EXPECT_EQ(FromMessage(answer.header), header_) << "a result keeps its source's header";
  const ForegroundMap foreground = ForegroundFromMessage(answer);
  EXPECT_EQ(foreground.map.cells, LocalMap().cells);
  EXPECT_EQ(foreground.is_foreground, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(foreground.status, BackgroundStatus::kSubtracted);
  EXPECT_EQ(service.loop().reporter().Status().state, service_status_t::RUNNING);
}

TEST_F(BackgroundSubtractionServiceTest, WithoutAMapEverythingIsForegroundAndTheStatusSaysSo) {
  BackgroundSubtractionService service(link_.lcm(), MemqLink::Options("background-subtraction"),
                                       BackgroundSubtractor());
  EXPECT_EQ(service.loop().reporter().Status().state, service_status_t::DEGRADED);
  link_.SendMessage("NDT_MAP_CAMERA", ToMessage(header_, LocalMap()));
  link_.Exchange(service.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_EQ(ForegroundFromMessage(Answer(0)).is_foreground, (std::vector<std::uint8_t>{1, 1}));
  const service_status_t status = service.loop().reporter().Status();
  EXPECT_EQ(status.state, service_status_t::DEGRADED);
  EXPECT_EQ(status.text, "no environment map: everything is foreground");
}

TEST_F(BackgroundSubtractionServiceTest, MapOutsideTheWorldIsForegroundAndTheStatusSaysSo) {
  BackgroundSubtractionService service(link_.lcm(), MemqLink::Options("background-subtraction"),
                                       BackgroundSubtractor(TableOnly()));
  NdtMap map = LocalMap();
  map.frame = MapFrame::kLevel;
  link_.SendMessage("NDT_MAP_CAMERA", ToMessage(header_, map));
  link_.Exchange(service.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_EQ(service.loop().reporter().Status().state, service_status_t::DEGRADED);
  EXPECT_THAT(service.loop().reporter().Status().text, HasSubstr("no pose"));
}

TEST_F(BackgroundSubtractionServiceTest, BrokenMessageAndOtherCellSizeAreCountedAndItGoesOn) {
  BackgroundSubtractionService service(link_.lcm(), MemqLink::Options("background-subtraction"),
                                       BackgroundSubtractor(TableOnly()));
  std::vector<std::uint8_t> broken = EncodeMessage(ToMessage(header_, LocalMap()));
  broken.resize(broken.size() / 2);
  link_.Send("NDT_MAP_CAMERA", broken);
  link_.SendMessage("NDT_MAP_CAMERA", ToMessage(header_, LocalMap(0.1)));
  link_.Exchange(service.loop());
  EXPECT_TRUE(link_.answers().empty());
  const service_status_t status = service.loop().reporter().Status();
  EXPECT_EQ(status.dropped_damaged, 2);
  EXPECT_EQ(status.state, service_status_t::DEGRADED);
  EXPECT_THAT(status.text, HasSubstr("cell size"));
  link_.SendMessage("NDT_MAP_CAMERA", ToMessage(header_, LocalMap()));
  link_.Exchange(service.loop());
  EXPECT_EQ(link_.answers().size(), 1U);
}

}  // namespace
}  // namespace fallen
