// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ndt_mapper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "ray_cast_scene.hpp"

namespace fallen {
namespace {

using Index = std::array<int, 3>;

GroundEstimate FloorSeenFrom(const Eigen::Isometry3d& T_world_camera,
                             const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  GroundEstimate ground;
  ground.status = GroundStatus::kOk;
  ground.plane = TransformPlane(T_world_camera.inverse(), Plane{{0, 0, 1}, -origin.z()});
  return ground;
}

const GroundEstimate kNoGround;

RayCastScene RoomWithPerson() {
  RayCastScene scene = FurnishedRoom();
  scene.ellipsoids = LyingPerson({2.2, 0, 0}, 0.6);
  return scene;
}

Index IndexOf(const Eigen::Vector3d& p, double cell_size_m) {
  return {static_cast<int>(std::floor(p.x() / cell_size_m)),
          static_cast<int>(std::floor(p.y() / cell_size_m)),
          static_cast<int>(std::floor(p.z() / cell_size_m))};
}

// All points of all images, in double, by voxel.
class Batch {
 public:
  explicit Batch(const NdtConfig& config) : config_(config) {}

  void Add(const DepthImage& image, const Eigen::Isometry3d& T_world_camera, double floor_m) {
    for (int v = 0; v < image.intrinsics.height; ++v)
      for (int u = 0; u < image.intrinsics.width; ++u) {
        const double z_m = image.depth_unit_m *
                           image.depth[static_cast<std::size_t>(v) * image.intrinsics.width + u];
        if (z_m == 0 || z_m < config_.min_range_m || z_m > config_.max_range_m) continue;
        const Eigen::Vector3d p = T_world_camera * image.intrinsics.Deproject(u, v, z_m);
        const double height = p.z() - floor_m;
        const double clearance =
            config_.ground_clearance_m + config_.ground_clearance_per_sq_m * z_m * z_m;
        if (height < clearance || height > config_.max_height_m) continue;
        const double distance = (p - T_world_camera.translation()).head<2>().norm();
        if (distance > config_.extent_m) continue;
        points_[IndexOf(p, config_.cell_size_m)].push_back(p);
        // A point on the fence may fall on either side of it by rounding.
        const double slack = std::min(
            {std::abs(height - clearance), std::abs(height - config_.max_height_m), ToFence(p)});
        if (slack < kRounding_m) unsure_[IndexOf(p, config_.cell_size_m)] = true;
        if (ToFence(p) < kRounding_m)
          for (int k = 0; k < 3; ++k)
            for (const double step : {-kRounding_m, kRounding_m}) {
              Eigen::Vector3d beside = p;
              beside[k] += 2 * step;
              unsure_[IndexOf(beside, config_.cell_size_m)] = true;
            }
      }
  }

  // Every cell of the map has the mean, covariance and count of its voxel's points.
  void ExpectEquals(const NdtMap& map, double mean_tolerance_m) const {
    int compared = 0, expected_cells = 0;
    for (const auto& [index, points] : points_)
      expected_cells += static_cast<int>(points.size()) >= config_.min_points ? 1 : 0;
    for (const NdtCell& cell : map.cells) {
      const Index index = IndexOf(cell.mean.cast<double>(), config_.cell_size_m);
      const auto found = points_.find(index);
      if (unsure_.contains(index) || found == points_.end()) continue;
      const std::vector<Eigen::Vector3d>& points = found->second;
      if (cell.point_count != points.size()) {
        ADD_FAILURE() << "count " << cell.point_count << " for " << points.size();
        continue;
      }
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& p : points) mean += p;
      mean /= static_cast<double>(points.size());
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for (const Eigen::Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose();
      covariance /= static_cast<double>(points.size() - 1);
      ASSERT_LT((cell.mean.cast<double>() - mean).norm(), mean_tolerance_m);
      // Disparity comes in steps: many cells are perfectly flat, and their eigenvalues are floored.
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
      const double largest = solver.eigenvalues()[2];
      const Eigen::Vector3d floored =
          solver.eigenvalues().cwiseMax(config_.min_eigenvalue_ratio * largest).cwiseMax(1e-9);
      covariance = solver.eigenvectors() * floored.asDiagonal() * solver.eigenvectors().transpose();
      // Each coordinate is right to 5e-7 m, a float's step at 4 m from the camera.
      ASSERT_LT((cell.CovarianceMatrix().cast<double>() - covariance).cwiseAbs().maxCoeff(),
                2 * std::sqrt(largest) * 5e-7 + 1e-10);
      ++compared;
    }
    EXPECT_GT(compared, 0.9 * expected_cells) << "of " << expected_cells;
    EXPECT_NEAR(static_cast<double>(map.cells.size()), expected_cells, 0.02 * expected_cells);
  }

 private:
  static constexpr double kRounding_m = 3e-6;
  double ToFence(const Eigen::Vector3d& p) const {
    const Eigen::Array3d cells = p.array() / config_.cell_size_m;
    return config_.cell_size_m * (cells - cells.round()).abs().minCoeff();
  }

  NdtConfig config_;
  std::map<Index, std::vector<Eigen::Vector3d>> points_;
  std::map<Index, bool> unsure_;
};

TEST(NdtMapper, OneFrameEqualsBatchStatistics) {
  const Eigen::Isometry3d pose = LookingDown({0.1, 0.2, 1.0}, 0.3, 0.4);
  std::mt19937 noise(1);
  const DepthImage image =
      WithSensorNoise(RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(640, 480), pose), noise);
  NdtConfig config;
  config.max_points_per_cell = 1000000;
  Batch batch(config);
  batch.Add(image, pose, 0);
  batch.ExpectEquals(NdtMapper(config).Update(0, image, pose, FloorSeenFrom(pose)), 3e-6);
}

// A kilometre out, float means are told in steps of 0.06 mm; covariances must not suffer at all.
TEST(NdtMapper, OneFrameEqualsBatchStatisticsFarFromTheOrigin) {
  const Eigen::Vector3d origin(1000.3, -700.7, 25.1);
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, -0.2, 0.5);
  std::mt19937 noise(2);
  const DepthImage image =
      WithSensorNoise(RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(320, 240), pose), noise);
  Eigen::Isometry3d far_pose = pose;
  far_pose.translation() += origin;
  NdtConfig config;
  config.max_points_per_cell = 1000000;
  Batch batch(config);
  batch.Add(image, far_pose, origin.z());
  const NdtMap map = NdtMapper(config).Update(0, image, far_pose, FloorSeenFrom(far_pose, origin));
  batch.ExpectEquals(map, 6e-5);
  EXPECT_NEAR(map.ground.plane.SignedHeight(far_pose.translation()), 1.0, 1e-9);
}

TEST(NdtMapper, AccumulationOverPosesEqualsBatchStatistics) {
  NdtConfig config;
  config.max_points_per_cell = 1000000;
  config.miss_log_odds = config.unseen_miss_log_odds = 0;  // nothing is forgotten
  NdtMapper mapper(config);
  Batch batch(config);
  std::mt19937 noise(3);
  NdtMap map;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Isometry3d pose = LookingDown({0.05 * i, -0.03 * i, 1.0}, 0.04 * i, 0.4);
    const DepthImage image =
        WithSensorNoise(RenderDepth(RoomWithPerson(), PrimeSenseIntrinsics(320, 240), pose), noise);
    batch.Add(image, pose, 0);
    map = mapper.Update(100000 * i, image, pose, FloorSeenFrom(pose));
  }
  batch.ExpectEquals(map, 3e-6);
}

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

TEST(NdtMapper, CovariancesArePositiveDefinite) {
  // A single row of pixels: every voxel's points lie on a line or on one spot.
  DepthImage line;
  line.intrinsics = {640, 1, 575, 575, 320, 0};
  line.depth.assign(640, 2000);
  DepthImage patch = line;  // a plane that faces the camera: no thickness at all
  patch.intrinsics.height = 40;
  patch.depth.assign(640 * 40, 2000);
  for (const DepthImage& image : {line, patch}) {
    const NdtMap map = NdtMapper().Update(0, image, std::nullopt, kNoGround);
    ASSERT_FALSE(map.cells.empty());
    for (const NdtCell& cell : map.cells) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
          cell.CovarianceMatrix().cast<double>());
      EXPECT_GT(solver.eigenvalues()[0], 0.99e-3 * solver.eigenvalues()[2]);
      EXPECT_GT(solver.eigenvalues()[0], 0.9e-9);
    }
  }
}

TEST(NdtMapper, NeedsTheConfiguredPoints) {
  DepthImage image;
  image.intrinsics = {5, 1, 575, 575, 0, 0};
  image.depth = {2000, 2000, 2000, 2000, 0};
  NdtConfig config;
  config.min_points = 4;
  EXPECT_EQ(NdtMapper(config).Update(0, image, std::nullopt, kNoGround).cells.size(), 1u);
  config.min_points = 5;
  EXPECT_TRUE(NdtMapper(config).Update(0, image, std::nullopt, kNoGround).cells.empty());
}

TEST(NdtMapper, AdaptsToASurfaceThatMovedWithinItsVoxel) {
  DepthImage image;
  image.intrinsics = {40, 40, 575, 575, 20, 20};
  NdtConfig config;
  config.without_pose = PoseMode::kFixedCamera;
  config.max_points_per_cell = 100;
  NdtMapper mapper(config);
  NdtMap map;
  for (int i = 0; i < 400; ++i) {
    image.depth.assign(1600, i < 200 ? 2010 : 2030);  // both in the voxels [2.00, 2.05)
    map = mapper.Update(100000 * i, image, std::nullopt, kNoGround);
  }
  ASSERT_FALSE(map.cells.empty());
  for (const NdtCell& cell : map.cells) {
    EXPECT_LE(cell.point_count, 100u);
    EXPECT_NEAR(cell.mean.z(), 2.03f, 0.002f);
  }
}

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

TEST(NdtConfig, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(NdtConfig().Validate());
  const auto expect_refused = [](auto change) {
    NdtConfig config;
    change(config);
    EXPECT_THROW(config.Validate(), std::invalid_argument);
    EXPECT_THROW(NdtMapper{config}, std::invalid_argument);
  };
  expect_refused([](NdtConfig& c) { c.cell_size_m = 0; });
  expect_refused([](NdtConfig& c) { c.cell_size_m = std::nan(""); });
  expect_refused([](NdtConfig& c) { c.min_points = 2; });
  expect_refused([](NdtConfig& c) { c.max_range_m = c.min_range_m / 2; });
  expect_refused([](NdtConfig& c) { c.extent_m = 0; });
  expect_refused([](NdtConfig& c) { c.max_points_per_cell = c.min_points - 1; });
  expect_refused([](NdtConfig& c) { c.min_eigenvalue_ratio = 2; });
  expect_refused([](NdtConfig& c) { c.miss_log_odds = -1; });
  expect_refused([](NdtConfig& c) { c.max_time_gap_s = -1; });
}

}  // namespace
}  // namespace fallen
