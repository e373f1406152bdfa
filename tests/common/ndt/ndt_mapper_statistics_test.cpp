// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cells against all points of all images at once, in double.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <map>

#include "fallen/ndt/ndt_mapper.hpp"
#include "mapped_room.hpp"

namespace fallen {
namespace {

using Index = std::array<int, 3>;

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

TEST(NdtMapperStatistics, OneFrameEqualsBatchStatistics) {
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
TEST(NdtMapperStatistics, OneFrameEqualsBatchStatisticsFarFromTheOrigin) {
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

TEST(NdtMapperStatistics, AccumulationOverPosesEqualsBatchStatistics) {
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

TEST(NdtMapperStatistics, CovariancesArePositiveDefinite) {
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

TEST(NdtMapperStatistics, NeedsTheConfiguredPoints) {
  DepthImage image;
  image.intrinsics = {5, 1, 575, 575, 0, 0};
  image.depth = {2000, 2000, 2000, 2000, 0};
  NdtConfig config;
  config.min_points = 4;
  EXPECT_EQ(NdtMapper(config).Update(0, image, std::nullopt, kNoGround).cells.size(), 1u);
  config.min_points = 5;
  EXPECT_TRUE(NdtMapper(config).Update(0, image, std::nullopt, kNoGround).cells.empty());
}

TEST(NdtMapperStatistics, AdaptsToASurfaceThatMovedWithinItsVoxel) {
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

}  // namespace
}  // namespace fallen
