// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// When the map starts anew, and when it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fallen/ndt/ndt_mapper.hpp"
#include "mapped_room.hpp"

namespace fallen {
namespace {

class Restarts : public testing::Test {
 protected:
  // A wall at 2 m or at 4 m; with the first gone, only the second's cells remain.
  DepthImage Wall(double depth_m) const {
    DepthImage image;
    image.intrinsics = {160, 120, 140, 140, 80, 60};
    // Half the image: the other half says nothing, so that occupancy removes nothing.
    image.depth.assign(160 * 120, 0);
    const std::size_t half = image.depth.size() / 2;
    for (std::size_t i = 0; i < half; ++i)
      image.depth[depth_m < 3 ? i : half + i] = static_cast<std::uint16_t>(1000 * depth_m);
    return image;
  }
  bool Remembers(const NdtMap& map) const {
    for (const NdtCell& cell : map.cells)
      if ((map.T_map_camera.inverse() * cell.mean.cast<double>()).z() < 3) return true;
    return false;
  }

  NdtMapper mapper_;
  Eigen::Isometry3d pose_ = LookingDown({0, 0, 1.0}, 0, 0.1);
  GroundEstimate ground_ = FloorSeenFrom(pose_);
};

TEST_F(Restarts, NotWhileFramesFollow) {
  mapper_.Update(1000000, Wall(2), pose_, ground_);
  EXPECT_TRUE(Remembers(mapper_.Update(1100000, Wall(4), pose_, ground_)));
  EXPECT_TRUE(Remembers(mapper_.Update(1100000, Wall(4), pose_, ground_))) << "the same time again";
  EXPECT_TRUE(Remembers(mapper_.Update(6099999, Wall(4), pose_, ground_)));
}

TEST_F(Restarts, WhenTheClockRunsBack) {
  mapper_.Update(1000000, Wall(2), pose_, ground_);
  EXPECT_FALSE(Remembers(mapper_.Update(999999, Wall(4), pose_, ground_)));
}

TEST_F(Restarts, AfterAGap) {
  mapper_.Update(1000000, Wall(2), pose_, ground_);
  EXPECT_FALSE(Remembers(mapper_.Update(6100000, Wall(4), pose_, ground_)));
}

TEST_F(Restarts, AtTimesThatAreFarApartBeyondMeasure) {
  mapper_.Update(std::numeric_limits<std::int64_t>::min(), Wall(2), pose_, ground_);
  EXPECT_FALSE(
      Remembers(mapper_.Update(std::numeric_limits<std::int64_t>::max(), Wall(4), pose_, ground_)));
}

TEST_F(Restarts, WhenThePoseIsLost) {
  mapper_.Update(1000000, Wall(2), pose_, ground_);
  const NdtMap level = mapper_.Update(1100000, Wall(4), std::nullopt, ground_);
  EXPECT_EQ(level.frame, MapFrame::kLevel);
  EXPECT_FALSE(Remembers(level));
}

TEST_F(Restarts, OnDemandAndWithoutAccumulation) {
  mapper_.Update(1000000, Wall(2), pose_, ground_);
  mapper_.Reset();
  EXPECT_FALSE(Remembers(mapper_.Update(1100000, Wall(4), pose_, ground_)));
  NdtConfig config;
  config.accumulate = false;
  NdtMapper single(config);
  single.Update(1000000, Wall(2), pose_, ground_);
  EXPECT_FALSE(Remembers(single.Update(1100000, Wall(4), pose_, ground_)));
}

TEST_F(Restarts, WithEachFrameWithoutAPose) {
  mapper_.Update(1000000, Wall(2), std::nullopt, ground_);
  EXPECT_FALSE(Remembers(mapper_.Update(1100000, Wall(4), std::nullopt, ground_)));
}

TEST_F(Restarts, NotForAFixedCamera) {
  NdtConfig config;
  config.without_pose = PoseMode::kFixedCamera;
  NdtMapper fixed(config);
  const NdtMap first = fixed.Update(1000000, Wall(2), std::nullopt, ground_);
  EXPECT_EQ(first.frame, MapFrame::kLevel);
  GroundEstimate jittered = ground_;
  jittered.plane.offset += 0.01;
  const NdtMap second = fixed.Update(1100000, Wall(4), std::nullopt, jittered);
  EXPECT_TRUE(Remembers(second));
  EXPECT_TRUE(second.T_map_camera.isApprox(first.T_map_camera)) << "its frame does not jitter";
  EXPECT_NEAR(second.ground.plane.offset, 0.01, 1e-12);
  const NdtMap lost = fixed.Update(1200000, Wall(4), std::nullopt, kNoGround);
  EXPECT_EQ(lost.frame, MapFrame::kCamera);
  EXPECT_FALSE(Remembers(lost));
}

}  // namespace
}  // namespace fallen
