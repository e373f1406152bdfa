// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/depth_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/simulate/time_of_flight.hpp"

namespace fallen::sim {
namespace {

// A wall across the optical axis at `depth`, seen by a camera at the origin that looks along +z.
Scene WallAt(double depth, double albedo = 0.8) {
  Scene scene;
  scene.shell = MakeBox({20, 20, 0.1}, albedo);
  scene.shell.Transform(
      Eigen::Affine3f(Eigen::Translation3f(0, 0, static_cast<float>(depth + 0.05))));
  return scene;
}

SensorImage Picture(const Scene& scene, const SensorConfig& config, int width = 320) {
  return TakePicture(RayCaster(scene), SensorIntrinsics(width), Eigen::Isometry3d::Identity(),
                     config, 5);
}

TEST(DepthSensor, WithoutNoiseAWallHasItsDepthEverywhere) {
  SensorConfig config;
  config.noise = false;
  const SensorImage image = Picture(WallAt(2), config);
  for (const std::uint16_t depth : image.depth.depth) ASSERT_EQ(depth, 2000);
  for (const std::uint8_t label : image.labels) ASSERT_EQ(label, 0);
}

TEST(DepthSensor, WithoutNoiseASlopeHasTheDepthOfItsPlane) {
  // The floor 1 m below a level camera: row v sees it at z = fy / (v - cy).
  Scene scene;
  scene.shell = MakeBox({20, 0.1, 20}, 0.5);
  scene.shell.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 1.05f, 0)));
  SensorConfig config;
  config.noise = false;
  const SensorImage image = Picture(scene, config);
  const CameraIntrinsics& k = image.depth.intrinsics;
  for (int v = 180; v < k.height; ++v)
    EXPECT_NEAR(image.depth.depth[static_cast<std::size_t>(v * k.width + 7)],
                1000 * k.fy / (v - k.cy), 1);
}

TEST(DepthSensor, NoiseHasTheSizeOfTheModelAndDisparityItsSteps) {
  for (const double wall : {1.0, 2.0, 3.0}) {
    const SensorImage image = Picture(WallAt(wall), {});
    double sum = 0, squares = 0;
    int count = 0;
    for (const std::uint16_t depth : image.depth.depth) {
      if (depth == 0) continue;
      const double disparity = 575 * 0.075 / (depth * 0.001);
      // Millimetres round the disparity by up to 0.022 px at 1 m, less farther away.
      EXPECT_NEAR(disparity * 8, std::round(disparity * 8), 0.18);
      sum += depth * 0.001 - wall;
      squares += (depth * 0.001 - wall) * (depth * 0.001 - wall);
      ++count;
    }
    ASSERT_GT(count, 0.98 * 320 * 240);
    const double step = wall * wall / (8 * 575 * 0.075);
    const double expected = std::hypot(AxialSigma(wall, 0), step / std::sqrt(12.0));
    EXPECT_NEAR(std::sqrt(squares / count), expected, 0.25 * expected) << wall;
    // A level between two disparity steps biases the mean by less than half a step.
    EXPECT_LT(std::abs(sum / count), step / 2) << wall;
  }
}

TEST(DepthSensor, AxialNoiseFollowsNguyen) {
  EXPECT_NEAR(AxialSigma(0.4, 0), 0.0012, 1e-6);
  EXPECT_NEAR(AxialSigma(2.4, 0), 0.0012 + 0.0019 * 4, 1e-6);
  EXPECT_GT(AxialSigma(1, 1.3), AxialSigma(1, 0.5));
}

TEST(DepthSensor, ProjectorCastsAShadowToTheLeftOfThings) {
  Scene scene = WallAt(2);
  scene.objects.push_back(PlaceObject("box", "b", MakeBox({0.4, 0.4, 0.02}, 0.8), {0, 0, 1.0}, 0));
  const SensorImage image = Picture(scene, {}, 640);
  const CameraIntrinsics& k = image.depth.intrinsics;
  // In the middle row: what is dark beside the box's left edge, and beside the right one.
  const int row = k.height / 2;
  const double edge_px = k.fx * 0.2 / 0.99, shadow_px = k.fx * 0.075 * (1 / 0.99 - 1 / 2.0);
  int left = 0, right = 0;
  for (int du = 6; du < 60; ++du) {
    const auto at = [&](double u) {
      return image.depth.depth[static_cast<std::size_t>(row * k.width + std::lround(u))];
    };
    left += at(k.cx - edge_px - du) == 0;
    right += at(k.cx + edge_px + du) == 0;
  }
  EXPECT_NEAR(left, shadow_px - 6, 4);  // [px], lateral noise frays the rim
  EXPECT_LE(right, 3);
}

TEST(DepthSensor, RangeLimitsAndWeakLightLeaveHoles) {
  const auto valid = [](const SensorImage& image) {
    int count = 0;
    for (const std::uint16_t depth : image.depth.depth) count += depth != 0;
    return count / (320.0 * 240);
  };
  EXPECT_EQ(valid(Picture(WallAt(0.4), {})), 0);
  EXPECT_EQ(valid(Picture(WallAt(5.6), {})), 0);
  EXPECT_GT(valid(Picture(WallAt(2, 0.3), {})), 0.97);
  EXPECT_LT(valid(Picture(WallAt(4.5, 0.02), {})), 0.4);
}

TEST(DepthSensor, HolesAreBlobsNotSpeckle) {
  // Of the holes in real Kinect recordings, less than 1 % are single pixels among valid ones.
  Scene scene = WallAt(3.2, 0.03);
  scene.objects.push_back(PlaceObject("box", "b", MakeBox({0.4, 0.4, 0.02}, 0.8), {0, 0, 1.5}, 0));
  const SensorImage image = Picture(scene, {}, 640);
  const auto hole = [&](int u, int v) {
    return image.depth.depth[static_cast<std::size_t>(v * 640 + u)] == 0;
  };
  int holes = 0, alone = 0;
  for (int v = 1; v < 479; ++v) {
    for (int u = 1; u < 639; ++u) {
      if (!hole(u, v)) continue;
      ++holes;
      alone += !hole(u - 1, v) && !hole(u + 1, v) && !hole(u, v - 1) && !hole(u, v + 1);
    }
  }
  EXPECT_GT(holes, 5000);
  EXPECT_LT(alone, holes / 50);
}

TEST(DepthSensor, IsDeterministicInItsSeed) {
  const RayCaster caster(WallAt(2));
  const auto take = [&](std::uint64_t seed) {
    return TakePicture(caster, SensorIntrinsics(320), Eigen::Isometry3d::Identity(), {}, seed)
        .depth.depth;
  };
  EXPECT_EQ(take(1), take(1));
  EXPECT_NE(take(1), take(2));
}

TEST(DepthSensor, RefusesAWidthThatTheSensorHasNot) {
  EXPECT_THROW(SensorIntrinsics(800), std::invalid_argument);
}

SensorImage TimeOfFlightPicture(const Scene& scene, SensorConfig config) {
  config.kind = SensorKind::kTimeOfFlight;
  return TakePicture(RayCaster(scene), SensorIntrinsics(320, config.kind),
                     Eigen::Isometry3d::Identity(), config, 5);
}

TEST(TimeOfFlight, WeakLightIsNoisier) {
  const auto spread = [](double albedo) {
    SensorConfig config = NominalSensor(SensorKind::kTimeOfFlight);
    config.wiggle_m = 0;
    const SensorImage image = TimeOfFlightPicture(WallAt(2, albedo), config);
    double squares = 0;
    int count = 0;
    for (const std::uint16_t depth : image.depth.depth) {
      if (depth == 0) continue;
      squares += (depth * 0.001 - 2) * (depth * 0.001 - 2);
      ++count;
    }
    return std::sqrt(squares / count);
  };
  // Straight ahead, A = albedo / 4; towards the corners there is less light.
  EXPECT_GT(spread(0.8), TimeOfFlightSigma(0.2));
  EXPECT_LT(spread(0.8), 2 * TimeOfFlightSigma(0.2));
  EXPECT_GT(spread(0.1), 2 * spread(0.8));
}

TEST(TimeOfFlight, EdgePixelsFlyBetweenNearAndFar) {
  Scene scene = WallAt(3);
  scene.objects.push_back(PlaceObject("box", "b", MakeBox({0.6, 0.6, 0.02}, 0.8), {0, 0, 1.5}, 0));
  const auto flying = [&](double share) {
    SensorConfig config = NominalSensor(SensorKind::kTimeOfFlight);
    config.edge_loss = 0;
    config.flying_share = share;
    const SensorImage image = TimeOfFlightPicture(scene, config);
    int count = 0;
    for (const std::uint16_t depth : image.depth.depth) count += depth > 1600 && depth < 2900;
    return count;
  };
  EXPECT_EQ(flying(0), 0);
  EXPECT_GT(flying(0.8), 150);  // the rim is some 360 pixels long, on either side
}

TEST(TimeOfFlight, CornersSeemFartherAwayThanTheyAre) {
  // Two walls that meet in a corner, straight ahead.
  Scene scene;
  for (const double side : {-1.0, 1.0}) {
    TriangleMesh wall = MakeBox({8, 8, 0.02}, 0.8);
    wall.Transform(
        Eigen::Translation3f(0, 0, 2.5f) *
        Eigen::AngleAxisf(static_cast<float>(side * M_PI / 4), Eigen::Vector3f::UnitY()));
    scene.shell.Append(wall);
  }
  const auto middle = [&](double multipath) {
    SensorConfig config = NominalSensor(SensorKind::kTimeOfFlight);
    config.multipath = multipath;
    const SensorImage image = TimeOfFlightPicture(scene, config);
    double sum = 0;
    int count = 0;
    for (int v = 40; v < 200; ++v) {
      for (int u = 158; u < 162; ++u) {
        const std::uint16_t depth = image.depth.depth[static_cast<std::size_t>(v * 320 + u)];
        sum += depth;
        count += depth != 0;
      }
    }
    return sum / count;
  };
  EXPECT_GT(middle(0.3), middle(0) + 3);  // [mm]
}

}  // namespace
}  // namespace fallen::sim
