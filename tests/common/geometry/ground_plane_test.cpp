// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::CameraPose;
using testing::Floor;
using testing::FrontWall;
using testing::kRadPerDeg;
using testing::LevelRectangle;
using testing::Rectangle;
using testing::Render;
using testing::Rendering;
using testing::SideWall;

// Noise of 0.15 pixel of disparity moves a plane through hundreds of points by less than this.
constexpr double kHeightTolerance_m = 0.015;
constexpr double kAngleTolerance_deg = 0.6;

GroundConfig ConfigFor(GroundMethod method) {
  GroundConfig config;
  config.method = method;
  return config;
}

void ExpectFloor(const GroundEstimate& estimate, const Eigen::Isometry3d& T_world_camera) {
  ASSERT_EQ(EnumName(estimate.status), "ok");
  const Plane truth = TransformPlane(T_world_camera.inverse(), Plane{});
  EXPECT_NEAR(estimate.plane.offset, truth.offset, kHeightTolerance_m);
  EXPECT_NEAR(std::acos(std::min(1.0, estimate.plane.normal.dot(truth.normal))) / kRadPerDeg, 0,
              kAngleTolerance_deg);
  EXPECT_NEAR(estimate.plane.normal.norm(), 1, 1e-12);
  EXPECT_NE(estimate.method, GroundMethod::kAuto);
  EXPECT_GT(estimate.point_count, 0);
  EXPECT_GE(estimate.inlier_count, GroundConfig().min_inlier_fraction * estimate.point_count);
  EXPECT_LE(estimate.inlier_count, estimate.point_count);
}

double ShareOf(const Rendering& rendering, std::size_t rectangle) {
  return static_cast<double>(rendering.pixels[rectangle]) /
         std::accumulate(rendering.pixels.begin(), rendering.pixels.end(), 0.0);
}

// What the plane is for: true floor, up to 4 m away and in view, is not far above or below it.
void ExpectFlatFloor(const Plane& plane, const Eigen::Isometry3d& T_world_camera) {
  const DepthImage floor = Render({Floor(), FrontWall(4)}, T_world_camera, /*noise=*/false).image;
  double worst = 0;
  for (int v = 0; v < 480; v += 5) {
    for (int u = 0; u < 640; u += 5) {
      const double z = 0.001 * floor.depth[static_cast<std::size_t>(v * 640 + u)];
      const Eigen::Vector3d p = floor.intrinsics.Deproject(u, v, z);
      if (z == 0 || (T_world_camera * p).z() > 0.002) continue;
      worst = std::max(worst, std::abs(plane.SignedHeight(p)) / (0.01 + 0.002 * z * z));
    }
  }
  EXPECT_LT(worst, 1);
}

class ImageBased : public ::testing::TestWithParam<GroundMethod> {
 protected:
  GroundEstimate Estimate(const DepthImage& image,
                          const std::optional<Eigen::Isometry3d>& mounting = std::nullopt) const {
    return EstimateGround(image, mounting, ConfigFor(GetParam()));
  }
};
INSTANTIATE_TEST_SUITE_P(Methods, ImageBased,
                         ::testing::Values(GroundMethod::kAuto, GroundMethod::kRansac,
                                           GroundMethod::kVDisparity),
                         [](const auto& method) { return std::string(EnumName(method.param)); });

TEST_P(ImageBased, FindsKnownHeightPitchAndRoll) {
  for (const double height : {0.3, 0.95, 1.4, 2.0}) {
    for (const double pitch : {0.0, 8.0, 27.0}) {
      for (const double roll : {-8.0, 0.0, 3.5}) {
        SCOPED_TRACE(::testing::Message()
                     << height << " m, " << pitch << " and " << roll << " deg");
        const Eigen::Isometry3d pose = CameraPose(height, pitch, roll);
        const Rendering rendering = Render({Floor(), FrontWall(4), SideWall(2.5)}, pose);
        const double share = ShareOf(rendering, 0);
        if (share < 0.04) continue;  // not a floor by `min_inlier_fraction`
        const GroundEstimate estimate = Estimate(rendering.image);
        ASSERT_TRUE(estimate.ok());
        ExpectFlatFloor(estimate.plane, pose);
        if (share > 0.2) ExpectFloor(estimate, pose);  // a far strip hardly fixes a height
      }
    }
  }
}

TEST_P(ImageBased, PrefersASmallFloorToLargerWallsTablesAndBeds) {
  const Eigen::Isometry3d pose = CameraPose(1.3, 25, 2);
  const Rectangle table = LevelRectangle(1.3, 0.85, 0.75, 0.8, 0.75);
  const Rectangle bed = LevelRectangle(1.8, -1.2, 0.45, 1.1, 1.0);
  const Rendering rendering =
      Render({Floor(), table, bed, FrontWall(2.4), SideWall(1.6), SideWall(-2.2)}, pose);
  ASSERT_GT(ShareOf(rendering, 1), 2 * ShareOf(rendering, 0));
  ASSERT_GT(ShareOf(rendering, 2), ShareOf(rendering, 0));
  ASSERT_GT(ShareOf(rendering, 3), ShareOf(rendering, 0));
  ExpectFloor(Estimate(rendering.image), pose);
}

TEST_P(ImageBased, FindsAFloorOfFivePercent) {
  const Eigen::Isometry3d pose = CameraPose(0.95, 4, -3);
  const Rendering rendering = Render({Floor(), FrontWall(2.1)}, pose);
  ASSERT_LT(ShareOf(rendering, 0), 0.07);
  ASSERT_GT(ShareOf(rendering, 0), 0.04);
  const GroundEstimate estimate = Estimate(rendering.image);
  ASSERT_TRUE(estimate.ok());
  ExpectFlatFloor(estimate.plane, pose);
}

TEST_P(ImageBased, WallsAloneAreNoFloor) {
  const Eigen::Isometry3d pose = CameraPose(1.2, 0, 3);
  for (const std::vector<Rectangle>& scene : {std::vector{FrontWall(1.2)},
                                              {FrontWall(2), SideWall(0.8)},
                                              {SideWall(0.6), SideWall(-0.7)}})
    EXPECT_EQ(EnumName(Estimate(Render(scene, pose).image).status), "no_floor_in_view");
}

TEST_P(ImageBased, CeilingIsNoFloor) {
  const Rectangle ceiling = LevelRectangle(0, 0, 2.4, 20, 20);
  const DepthImage image = Render({ceiling, FrontWall(4)}, CameraPose(1.0, -20, 0)).image;
  EXPECT_EQ(EnumName(Estimate(image).status), "no_floor_in_view");
}

// The floor beyond the table's edge is less than `min_inlier_fraction`, but what is seen there lies
// below the table.
TEST_P(ImageBased, TableWithSomethingBelowItIsNoFloor) {
  const Eigen::Isometry3d pose = CameraPose(1.25, 15, 0);
  const Rectangle table = LevelRectangle(0.7, 0, 0.75, 0.5, 3);
  const Rendering rendering =
      Render({LevelRectangle(3.3, 0.2, 0, 0.3, 0.4), table, FrontWall(3.6)}, pose);
  ASSERT_LT(ShareOf(rendering, 0), GroundConfig().min_inlier_fraction);
  ASSERT_GT(ShareOf(rendering, 0), 0.01);
  ASSERT_GT(ShareOf(rendering, 1), 0.3);
  EXPECT_EQ(EnumName(Estimate(rendering.image).status), "no_floor_in_view");
}

TEST_P(ImageBased, TableThatFillsTheViewIsNoFloorForACameraThatIsHigher) {
  const DepthImage image =
      Render({LevelRectangle(0, 0, 0.75, 20, 20), FrontWall(4)}, CameraPose(1.25, 20, 0)).image;
  GroundConfig config = ConfigFor(GetParam());
  config.min_camera_height_m = 0.8;
  EXPECT_EQ(EnumName(EstimateGround(image, std::nullopt, config).status), "no_floor_in_view");
}

TEST_P(ImageBased, RandomDepthIsNoFloor) {
  DepthImage image{{640, 480, 570, 570, 319.5, 239.5}, 0.001, {}};
  std::mt19937_64 random(3);
  for (int i = 0; i < 640 * 480; ++i)
    image.depth.push_back(static_cast<std::uint16_t>(random() % 5000));
  EXPECT_EQ(EnumName(Estimate(image).status), "no_floor_in_view");
}

TEST_P(ImageBased, HardlyAnyDepthIsTooFewPoints) {
  DepthImage image{
      {640, 480, 570, 570, 319.5, 239.5}, 0.001, std::vector<std::uint16_t>(640 * 480)};
  EXPECT_EQ(EnumName(Estimate(image).status), "too_few_points");
  image.depth[640 * 300 + 320] = 1000;
  EXPECT_EQ(EnumName(Estimate(image).status), "too_few_points");
}

TEST_P(ImageBased, TinyImagesDoNoHarm) {
  for (const int side : {1, 2, 3, 7, 12}) {
    const DepthImage image{{side, side, 10, 10, side / 2.0, side / 2.0},
                           0.001,
                           std::vector<std::uint16_t>(static_cast<std::size_t>(side * side), 900)};
    EXPECT_FALSE(Estimate(image).ok()) << side;
  }
}

TEST_P(ImageBased, ExtremeDepthsAndUnitsDoNoHarm) {
  for (const double unit : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    DepthImage image = Render({Floor()}, CameraPose(1, 10, 0)).image;
    image.depth_unit_m = unit;
    EXPECT_FALSE(Estimate(image).ok()) << unit;
  }
}

TEST_P(ImageBased, DepthUnitIsHeeded) {
  const Eigen::Isometry3d pose = CameraPose(1, 10, 0);
  DepthImage image = Render({Floor(), FrontWall(4)}, pose).image;
  for (std::uint16_t& depth : image.depth) depth = static_cast<std::uint16_t>(10 * depth);
  image.depth_unit_m = 0.0001;
  ExpectFloor(Estimate(image), pose);
}

TEST_P(ImageBased, SmallImagesWillDo) {
  const Eigen::Isometry3d pose = CameraPose(0.9, 12, -2);
  const DepthImage large = Render({Floor(), FrontWall(4)}, pose).image;
  DepthImage small{{160, 120, 142.5, 142.5, 79.5, 59.5}, 0.001, {}};
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u)
      small.depth.push_back(large.depth[static_cast<std::size_t>(4 * v * 640 + 4 * u)]);
  small.intrinsics.cx = 319.5 / 4;
  small.intrinsics.cy = 239.5 / 4;
  ExpectFloor(Estimate(small), pose);
}

TEST_P(ImageBased, EqualArgumentsGiveEqualResults) {
  const DepthImage image =
      Render({Floor(), LevelRectangle(2, 0.5, 0.7, 0.6, 0.6), FrontWall(3)}, CameraPose(1.1, 20, 1))
          .image;
  const GroundEstimate first = Estimate(image);
  ASSERT_TRUE(first.ok());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Estimate(image), first);
}

TEST_P(ImageBased, MountingLetsTheCameraLookSteeplyDownOrRoll) {
  for (const auto& [pitch, roll] :
       {std::pair(55.0, 0.0), {20.0, 25.0}, {30.0, -90.0}, {10.0, 180.0}}) {
    SCOPED_TRACE(::testing::Message() << pitch << " and " << roll << " deg");
    const Eigen::Isometry3d pose = CameraPose(1.2, pitch, roll);
    const DepthImage image = Render({Floor(), FrontWall(3)}, pose).image;
    ExpectFloor(Estimate(image, pose), pose);
  }
}

TEST_P(ImageBased, RefusesMalformedArguments) {
  const DepthImage image = Render({Floor()}, CameraPose(1, 10, 0)).image;
  EXPECT_THROW(Estimate(DepthImage()), std::invalid_argument);
  DepthImage short_image = image;
  short_image.depth.pop_back();
  EXPECT_THROW(Estimate(short_image), std::invalid_argument);
  Eigen::Isometry3d mounting = CameraPose(1, 10, 0);
  mounting.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Estimate(image, mounting), std::invalid_argument);
  mounting = CameraPose(1, 10, 0);
  mounting.linear() *= 1.01;
  EXPECT_THROW(Estimate(image, mounting), std::invalid_argument);
  mounting = CameraPose(1, 10, 0);
  mounting.linear().col(0) *= -1;
  EXPECT_THROW(Estimate(image, mounting), std::invalid_argument);
  EXPECT_THROW(Estimate(image, CameraPose(-0.1, 10, 0)), std::invalid_argument);
}

TEST(Ransac, AnySeedFindsTheFloor) {
  const Eigen::Isometry3d pose = CameraPose(1.2, 22, -4);
  const DepthImage image =
      Render({Floor(), LevelRectangle(1.5, 0.6, 0.75, 0.7, 0.8), FrontWall(2.6)}, pose).image;
  GroundConfig config = ConfigFor(GroundMethod::kRansac);
  for (config.ransac_seed = -3; config.ransac_seed < 30; ++config.ransac_seed)
    ExpectFloor(EstimateGround(image, std::nullopt, config), pose);
}

TEST(Auto, WithoutAMountingRansacSpeaks) {
  const DepthImage image = Render({Floor(), FrontWall(3)}, CameraPose(1, 10, 0)).image;
  EXPECT_EQ(EstimateGround(image, std::nullopt).method, GroundMethod::kRansac);
  EXPECT_EQ(EstimateGround(image, std::nullopt),
            EstimateGround(image, std::nullopt, ConfigFor(GroundMethod::kRansac)));
}

TEST(Auto, CorrectsAMountingThatIsALittleOff) {
  const Eigen::Isometry3d pose = CameraPose(1.0, 15, 1);
  const DepthImage image = Render({Floor(), FrontWall(3)}, pose).image;
  const GroundEstimate estimate = EstimateGround(image, CameraPose(1.06, 17.5, -1));
  EXPECT_EQ(estimate.method, GroundMethod::kRansac);
  ExpectFloor(estimate, pose);
}

TEST(Auto, KeepsTheMountingWhereNoFloorIsInView) {
  const Eigen::Isometry3d pose = CameraPose(1.2, 10, 0);
  const GroundEstimate by_mounting =
      EstimateGround(Render({FrontWall(1)}, pose).image, pose, ConfigFor(GroundMethod::kMounting));
  const std::vector<std::vector<Rectangle>> scenes = {
      {}, {FrontWall(1)}, {LevelRectangle(0, 0, 0.75, 20, 20)}};
  for (const auto& scene : scenes) {
    const GroundEstimate estimate = EstimateGround(Render(scene, pose).image, pose);
    EXPECT_TRUE(estimate.ok());
    EXPECT_EQ(estimate.method, GroundMethod::kMounting);
    EXPECT_EQ(estimate.plane, by_mounting.plane);
    EXPECT_EQ(estimate.inlier_count, 0);
  }
}

TEST(Auto, DoesNotFollowTheImageFartherThanTheMountingCanBeOff) {
  const DepthImage image = Render({Floor(), FrontWall(3)}, CameraPose(1.0, 15, 0)).image;
  const Eigen::Isometry3d mounting = CameraPose(1.3, 15, 0);
  const GroundEstimate estimate = EstimateGround(image, mounting);
  EXPECT_EQ(estimate.method, GroundMethod::kMounting);
  EXPECT_NEAR(estimate.plane.offset, 1.3, 1e-12);
}

TEST(Mounting, IsTheRobotsFloorExactly) {
  const Eigen::Isometry3d mounting = CameraPose(1.1, 23, -7);
  const DepthImage image = Render({}, mounting).image;
  const GroundEstimate estimate =
      EstimateGround(image, mounting, ConfigFor(GroundMethod::kMounting));
  EXPECT_TRUE(estimate.ok());
  EXPECT_EQ(estimate.method, GroundMethod::kMounting);
  EXPECT_EQ(estimate.plane.offset, 1.1);
  EXPECT_EQ(estimate.plane.normal, mounting.linear().row(2).transpose());
  EXPECT_EQ(estimate.point_count, 0);  // no pixel was looked at
  const Eigen::Vector3d on_floor = mounting.inverse() * Eigen::Vector3d(3, -2, 0);
  EXPECT_NEAR(estimate.plane.SignedHeight(on_floor), 0, 1e-12);
}

TEST(Mounting, MissingIsAStatus) {
  const DepthImage image = Render({Floor()}, CameraPose(1, 10, 0)).image;
  EXPECT_EQ(EstimateGround(image, std::nullopt, ConfigFor(GroundMethod::kMounting)).status,
            GroundStatus::kNoMounting);
}

TEST(GroundConfig, ValidateRefusesNonsense) {
  EXPECT_NO_THROW(GroundConfig().Validate());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    GroundConfig config;
    change(config);
    EXPECT_THROW(config.Validate(), std::invalid_argument);
  };
  refused([](auto& c) { c.method = static_cast<GroundMethod>(9); });
  refused([](auto& c) { c.inlier_distance_m = 0; });
  refused([&](auto& c) { c.inlier_distance_m = nan; });
  refused([](auto& c) { c.max_tilt_deg = 90; });
  refused([](auto& c) { c.max_tilt_deg = 0; });
  refused([](auto& c) { c.max_mounting_error_deg = -1; });
  refused([&](auto& c) { c.max_mounting_error_m = nan; });
  refused([](auto& c) { c.min_camera_height_m = 0; });
  refused([](auto& c) { c.max_camera_height_m = c.min_camera_height_m; });
  refused([&](auto& c) { c.max_camera_height_m = nan; });
  refused([](auto& c) { c.min_inlier_fraction = 0; });
  refused([](auto& c) { c.min_inlier_fraction = 1; });
  refused([](auto& c) { c.ransac_iterations = 0; });
  refused([](auto& c) { c.sample_points = 99; });
}

TEST(GroundConfig, ErrorSaysWhatWasGotAndExpected) {
  GroundConfig config;
  config.max_tilt_deg = 95;
  try {
    config.Validate();
    FAIL() << "must throw";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "ground: max_tilt_deg is 95, must be in (0, 90)");
  }
}

}  // namespace
}  // namespace fallen
