// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/composition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "fallen/geometry/ground_plane.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/compose/half_cylinder.hpp"
#include "tools/compose/free_places.hpp"
#include "tools/compose/sensor_noise.hpp"
#include "tools/compose/splat_rendering.hpp"

namespace fallen {
namespace {

constexpr double kToleranceM = 0.015;  // of the depth: less than points are apart

class Composing : public testing::Test {
 protected:
  Frame scene_ = lying_scene::Render(1, 0, lying_scene::With::kNobody);
  Eigen::Isometry3d T_level_camera_ = LevelFrameFromGround(EstimateGround(scene_.image, {}).plane);
  PersonCloud person_ = MakePersonCloud(HalfCylinder(), CloudUp::kMinusY);
};

TEST_F(Composing, PersonStandsOnTheFloorAcrossTheView) {
  EXPECT_NEAR(person_.box.size.x(), kBodyLengthM, 0.05);
  EXPECT_NEAR(person_.box.size.y(), 2 * kBodyRadiusM, 0.05);
  EXPECT_NEAR(person_.box.center.z() - person_.box.size.z() / 2, 0, 1e-9);
  EXPECT_NEAR(person_.box.size.z(), kBodyRadiusM, 0.03);
  EXPECT_NEAR(std::abs(std::sin(person_.box.yaw)), 1, 1e-3);
}

TEST_F(Composing, SurfaceHasNoHolesAndTheDepthOfTheCylinder) {
  // 1.2 m away the points are 4 pixels of a 320 pixel wide image apart, of a wider one 8.
  CameraIntrinsics camera = scene_.image.intrinsics;
  camera = {2 * camera.width, 2 * camera.height, 2 * camera.fx,
            2 * camera.fy,    2 * camera.cx,     2 * camera.cy};
  const Place near{1.2, 0, 0};
  const Eigen::Isometry3d T_camera_person = T_level_camera_.inverse() * near.Pose();
  const std::vector<double> depth = RenderSplats(person_.splats, camera, T_camera_person);
  int seen = 0;
  for (double along = -0.6; along <= 0.6; along += 0.01)
    for (double angle = 1.5; angle <= 2.6; angle += 0.1) {
      // The near side of the cylinder: x of the person's frame points away from the camera.
      const Eigen::Vector3d p =
          T_camera_person *
          Eigen::Vector3d(kBodyRadiusM * std::cos(angle), along, kBodyRadiusM * std::sin(angle));
      const Eigen::Vector2d pixel = camera.Project(p);
      const int u = static_cast<int>(std::lround(pixel.x()));
      const int v = static_cast<int>(std::lround(pixel.y()));
      if (u < 0 || v < 0 || u >= camera.width || v >= camera.height) continue;
      ++seen;
      ASSERT_NEAR(depth[static_cast<std::size_t>(v) * camera.width + u], p.z(), kToleranceM)
          << "along " << along << ", angle " << angle;
    }
  EXPECT_GT(seen, 500);
}

TEST_F(Composing, WhatIsInFrontHidesThePerson) {
  const Place place{2, 0, 0};
  const Composition whole = Compose(scene_.image, T_level_camera_, person_, place.Pose());
  DepthImage blocked = scene_.image;
  const int width = blocked.intrinsics.width;
  for (int v = 0; v < blocked.intrinsics.height; ++v)
    for (int u = 0; u < width / 2; ++u)
      blocked.depth[static_cast<std::size_t>(v) * width + u] = 600;  // a post at 0.6 m
  const Composition half = Compose(blocked, T_level_camera_, person_, place.Pose());
  EXPECT_GT(whole.visible_share, 0.99);
  EXPECT_NEAR(half.visible_share, 0.5, 0.03);
  for (std::size_t i = 0; i < blocked.depth.size(); ++i)
    if (blocked.depth[i] == 600) {
      ASSERT_EQ(half.image.depth[i], 600);
      ASSERT_FALSE(half.is_person[i]);
    }
}

TEST_F(Composing, OnlyThePersonsPixelsChange) {
  const Composition result = Compose(scene_.image, T_level_camera_, person_, Place{2, 0, 0}.Pose());
  int changed = 0;
  for (std::size_t i = 0; i < scene_.image.depth.size(); ++i) {
    if (!result.is_person[i]) {
      ASSERT_EQ(result.image.depth[i], scene_.image.depth[i]);
    }
    changed += result.is_person[i];
  }
  EXPECT_GT(changed, 1000);
}

TEST_F(Composing, PlacesKeepClearOfWhatStandsThere) {
  PlaceSearch search;
  const auto free = FindFreePlaces(scene_.image, T_level_camera_, person_.box, search);
  ASSERT_FALSE(free.empty());
  const Frame with_block = lying_scene::Render(1, 0, lying_scene::With::kPerson);
  const OrientedBox block = lying_scene::Person();
  const auto beside = FindFreePlaces(with_block.image, T_level_camera_, person_.box, search);
  EXPECT_LT(beside.size(), free.size());
  for (const Place& place : beside)
    EXPECT_FALSE(BoxAt(place, person_.box).Contains({block.center.x(), block.center.y(), 0.05}));
}

TEST_F(Composing, WhatWasCutAwayWithTheFloorIsContinuedDownToIt) {
  const double cut_m = kBodyRadiusM * std::sin(std::numbers::pi * 2 / 27);  // the third row
  std::vector<Eigen::Vector3d> points = HalfCylinder();
  std::erase_if(points, [&](const Eigen::Vector3d& p) { return p.y() > 1 - cut_m + 1e-9; });
  const PersonCloud sunk = MakePersonCloud(points, CloudUp::kMinusY);
  const PersonCloud restored = MakePersonCloud(points, CloudUp::kMinusY, cut_m);
  EXPECT_LT(sunk.box.size.z(), person_.box.size.z() - 0.03);
  EXPECT_NEAR(restored.box.size.z(), person_.box.size.z(), 0.01);

  CompositionConfig config;
  config.noise_scale = 0;
  const Eigen::Isometry3d pose = Place{2, 0, 0}.Pose();
  const Composition whole = Compose(scene_.image, T_level_camera_, person_, pose, config);
  const auto pixels_that_differ = [&](const PersonCloud& person) {
    const Composition other = Compose(scene_.image, T_level_camera_, person, pose, config);
    return std::inner_product(whole.is_person.begin(), whole.is_person.end(),
                              other.is_person.begin(), 0, std::plus<>(), std::not_equal_to<>());
  };
  EXPECT_LT(2 * pixels_that_differ(restored), pixels_that_differ(sunk));
}

TEST_F(Composing, PersonIsAsNoisyAsTheCameraWouldSeeIt) {
  CameraIntrinsics camera = scene_.image.intrinsics;
  std::vector<double> wall(static_cast<std::size_t>(camera.width) * camera.height, 2.5);
  EXPECT_EQ(AddSensorNoise(wall, camera, 0, 1), wall);
  EXPECT_EQ(AddSensorNoise(wall, camera, 1, 1), AddSensorNoise(wall, camera, 1, 1));
  EXPECT_NE(AddSensorNoise(wall, camera, 1, 1), AddSensorNoise(wall, camera, 1, 2));
  for (const double scale : {0.5, 1.0}) {
    double sum = 0, sq_sum = 0;
    int count = 0;
    for (const double z_m : AddSensorNoise(wall, camera, scale, 3)) {
      if (z_m == 0) continue;  // seen past the picture's border
      ++count;
      sum += z_m - 2.5;
      sq_sum += (z_m - 2.5) * (z_m - 2.5);
    }
    ASSERT_GT(count, 0.95 * static_cast<double>(wall.size()));
    EXPECT_NEAR(sum / count, 0, 0.001);
    // [Nguyen12, Eq. 3]: 1.2 mm + 1.9 mm/m^2 (2.5 m - 0.4 m)^2
    EXPECT_NEAR(std::sqrt(sq_sum / count), scale * 0.0096, 0.001);
  }
  // Across the ray: an outline is frayed, and nothing appears far from it.
  for (int v = 0; v < camera.height; ++v)
    std::fill_n(wall.begin() + static_cast<std::ptrdiff_t>(v) * camera.width, camera.width / 2, 0);
  const std::vector<double> half = AddSensorNoise(wall, camera, 1, 4);
  int frayed = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 5; u < camera.width - 5; ++u) {
      const auto i = static_cast<std::size_t>(v) * camera.width + u;
      const bool differs = (half[i] > 0) != (wall[i] > 0);
      frayed += differs;
      if (std::abs(u - camera.width / 2) > 4 && v >= 5 && v < camera.height - 5) {
        ASSERT_FALSE(differs) << u << ' ' << v;
      }
    }
  EXPECT_GT(frayed, 10);
}

TEST_F(Composing, TooFewPointsAreNoPerson) {
  EXPECT_THROW(MakePersonCloud({{0, 1, 3}, {0.1, 1, 3}}, CloudUp::kMinusY), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
