// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ndt_mapper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mapped_room.hpp"

namespace fallen {
namespace {

TEST(NdtMapper, GivesTheSameBitsForTheSameSequence) {
  NdtMapper first, second;
  std::mt19937 noise(1);
  second.Update(
      5, RenderDepth(FurnishedRoom(), PrimeSenseIntrinsics(80, 60), LookingDown({0, 0, 1}, 0, 0.3)),
      std::nullopt, kNoGround);
  second.Reset();
  for (int i = 0; i < 5; ++i) {
    const Eigen::Isometry3d pose = LookingDown({0.1 * i, 0, 1.0}, 0.1 * i, 0.4);
    const DepthImage image =
        WithSensorNoise(RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(160, 120), pose), noise);
    const NdtMap a = first.Update(100000 * i, image, pose, FloorSeenFrom(pose));
    const NdtMap b = second.Update(100000 * i, image, pose, FloorSeenFrom(pose));
    ASSERT_FALSE(a.cells.empty());
    ASSERT_EQ(a.cells, b.cells);
  }
}

TEST(NdtMapper, TakesTheFloorAwayButNotThePerson) {
  RayCastScene scene;
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.5);
  std::mt19937 noise(2);
  const CameraIntrinsics camera = PrimeSenseIntrinsics(640, 480);
  const DepthImage floor_only = WithSensorNoise(RenderDepth(scene, camera, pose), noise);
  EXPECT_TRUE(NdtMapper().Update(0, floor_only, pose, FloorSeenFrom(pose)).cells.empty());
  scene.ellipsoids = LyingPerson({2, 0, 0}, 1.2);
  const DepthImage with_person = WithSensorNoise(RenderDepth(scene, camera, pose), noise);
  const NdtMap map = NdtMapper().Update(0, with_person, pose, FloorSeenFrom(pose));
  EXPECT_GT(map.cells.size(), 150u);
  for (const NdtCell& cell : map.cells)
    EXPECT_LT((cell.mean.cast<double>() - Eigen::Vector3d(2, 0, 0.1)).norm(), 1.1);
}

TEST(NdtMapper, LeavesOutWhatIsTooHighTooNearOrTooFar) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.2);
  const DepthImage image = RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(320, 240), pose);
  NdtConfig config;
  config.min_range_m = 1.5;
  config.max_range_m = 3.0;
  config.max_height_m = 0.8;
  const NdtMap map = NdtMapper(config).Update(0, image, pose, FloorSeenFrom(pose));
  ASSERT_FALSE(map.cells.empty());
  for (const NdtCell& cell : map.cells) {
    const double depth_m = (pose.inverse() * cell.mean.cast<double>()).z();
    EXPECT_GE(depth_m, 1.5 - 1e-3);
    EXPECT_LE(depth_m, 3.0 + 1e-3);
    EXPECT_LE(cell.mean.z(), 0.8f + 1e-5f);
  }
}

TEST(NdtMapper, ForgetsWhatLiesBeyondItsExtent) {
  NdtConfig config;
  config.extent_m = 4;
  NdtMapper mapper(config);
  const CameraIntrinsics camera = PrimeSenseIntrinsics(160, 120);
  const Eigen::Isometry3d there = LookingDown({0, 0, 1.0}, 0, 0.4);
  const NdtMap before =
      mapper.Update(0, RenderDepth(RoomWithPerson(), camera, there), there, FloorSeenFrom(there));
  ASSERT_FALSE(before.cells.empty());
  const Eigen::Isometry3d away = LookingDown({-4, 0, 1.0}, 3.14, 0.4);
  const NdtMap after =
      mapper.Update(100000, RenderDepth(RayCastScene(), camera, away), away, FloorSeenFrom(away));
  for (const NdtCell& cell : after.cells) {
    const Eigen::Vector3d offset = cell.mean.cast<double>() - away.translation();
    EXPECT_LE(offset.head<2>().norm(), config.extent_m + 1e-6);
  }
  EXPECT_LT(after.cells.size(), before.cells.size() / 4);
}

TEST(NdtMapper, SaysInWhichFrameItsMapIs) {
  const Eigen::Isometry3d pose = LookingDown({3, -2, 1.2}, 1.0, 0.4);
  const GroundEstimate ground = FloorSeenFrom(pose);
  const DepthImage image =
      RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(80, 60), LookingDown({0, 0, 1.2}, 0, 0.4));
  const NdtMap world = NdtMapper().Update(0, image, pose, ground);
  EXPECT_EQ(world.frame, MapFrame::kWorld);
  EXPECT_TRUE(world.T_map_camera.isApprox(pose));
  EXPECT_NEAR(world.ground.plane.normal.z(), 1, 1e-12);
  EXPECT_NEAR(world.ground.plane.offset, 0, 1e-12);

  const NdtMap level = NdtMapper().Update(0, image, std::nullopt, ground);
  EXPECT_EQ(level.frame, MapFrame::kLevel);
  EXPECT_TRUE(level.T_map_camera.translation().isApprox(Eigen::Vector3d(0, 0, 1.2), 1e-9));
  for (const NdtCell& cell : level.cells) EXPECT_GE(cell.mean.z(), 0.04f);

  const NdtMap camera = NdtMapper().Update(0, image, std::nullopt, kNoGround);
  EXPECT_EQ(camera.frame, MapFrame::kCamera);
  EXPECT_TRUE(camera.T_map_camera.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_FALSE(camera.ground.ok());
  EXPECT_GT(camera.cells.size(), level.cells.size()) << "the floor is still in it";
}

// Frames in which no floor was found leave its cells in the map; they go when it is found again.
TEST(NdtMapper, DropsFloorThatCameInWhileNoFloorWasKnown) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.5);
  std::mt19937 noise(3);
  const DepthImage floor =
      WithSensorNoise(RenderDepth(RayCastScene(), PrimeSenseIntrinsics(320, 240), pose), noise);
  NdtMapper mapper;
  EXPECT_FALSE(mapper.Update(0, floor, pose, kNoGround).cells.empty());
  EXPECT_TRUE(mapper.Update(100000, floor, pose, FloorSeenFrom(pose)).cells.empty());
}

TEST(NdtMapper, TakesImagesWithoutDepth) {
  DepthImage image;
  image.intrinsics = {1, 1, 575, 575, 0, 0};
  image.depth = {0};
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.5);
  EXPECT_TRUE(NdtMapper().Update(0, image, pose, FloorSeenFrom(pose)).cells.empty());
  image.depth = {2000};
  EXPECT_TRUE(NdtMapper().Update(0, image, pose, kNoGround).cells.empty());
}

TEST(NdtMapper, RefusesPosesGroundAndImagesThatMakeNoSense) {
  NdtMapper mapper;
  const DepthImage image =
      RenderDepth(FurnishedRoom(), PrimeSenseIntrinsics(80, 60), LookingDown({0, 0, 1.2}, 0, 0.4));
  const auto expect_refused = [&](const Eigen::Isometry3d& pose) {
    EXPECT_THROW(mapper.Update(0, image, pose, kNoGround), std::invalid_argument);
  };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = std::nan("");
  expect_refused(pose);
  pose.translation().x() = 1e9;
  expect_refused(pose);
  pose = Eigen::Isometry3d::Identity();
  pose.linear()(0, 0) = std::numeric_limits<double>::infinity();
  expect_refused(pose);
  pose.linear() = 2 * Eigen::Matrix3d::Identity();
  expect_refused(pose);

  GroundEstimate ground = FloorSeenFrom(Eigen::Isometry3d::Identity());
  ground.plane.offset = std::nan("");
  EXPECT_THROW(mapper.Update(0, image, std::nullopt, ground), std::invalid_argument);
  DepthImage torn = image;
  torn.depth.pop_back();
  EXPECT_THROW(mapper.Update(0, torn, std::nullopt, kNoGround), std::invalid_argument);
  EXPECT_FALSE(mapper.Update(0, image, std::nullopt, kNoGround).cells.empty()) << "still works";
}

}  // namespace
}  // namespace fallen
