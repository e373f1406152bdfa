// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fallen/geometry/camera_intrinsics.hpp"
#include "fallen/geometry/depth_image.hpp"

namespace fallen {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CameraIntrinsics Xtion() { return {640, 480, 570, 571, 319.5, 239.5}; }

TEST(CameraIntrinsics, DeprojectsByHandWorkedExample) {
  const CameraIntrinsics camera{640, 480, 500, 400, 320, 240};
  EXPECT_TRUE(camera.Deproject(420, 200, 2.0).isApprox(Eigen::Vector3d(0.4, -0.2, 2.0), 1e-15));
}

TEST(CameraIntrinsics, ProjectUndoesDeproject) {
  const CameraIntrinsics camera = Xtion();
  const Eigen::Vector2d pixel = camera.Project(camera.Deproject(17, 433, 3.21));
  EXPECT_NEAR(pixel.x(), 17, 1e-12);
  EXPECT_NEAR(pixel.y(), 433, 1e-12);
}

TEST(CameraIntrinsics, ValidateRefusesNonsense) {
  EXPECT_NO_THROW(Xtion().Validate());
  const auto refused = [](auto change) {
    CameraIntrinsics camera = Xtion();
    change(camera);
    EXPECT_THROW(camera.Validate(), std::invalid_argument);
  };
  refused([](auto& c) { c.width = 0; });
  refused([](auto& c) { c.height = -1; });
  refused([](auto& c) { c.width = 8193; });
  refused([](auto& c) { c.fx = 0; });
  refused([](auto& c) { c.fy = -570; });
  refused([](auto& c) { c.fx = kNan; });
  refused([](auto& c) { c.fy = kInfinity; });
  refused([](auto& c) { c.cx = kNan; });
  refused([](auto& c) { c.cy = -kInfinity; });
}

TEST(CameraIntrinsics, ErrorSaysWhatWasGotAndExpected) {
  CameraIntrinsics camera = Xtion();
  camera.height = 9000;
  try {
    camera.Validate();
    FAIL() << "must throw";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "camera_intrinsics: height is 9000, must be in [1, 8192]");
  }
}

TEST(DepthImage, ValidateChecksSizeUnitAndIntrinsics) {
  DepthImage image{Xtion(), 0.001, std::vector<std::uint16_t>(640 * 480)};
  EXPECT_NO_THROW(image.Validate());
  image.depth.pop_back();
  EXPECT_THROW(image.Validate(), std::invalid_argument);
  image.depth.resize(640 * 480);
  for (const double unit : {0.0, -0.001, kNan, kInfinity}) {
    image.depth_unit_m = unit;
    EXPECT_THROW(image.Validate(), std::invalid_argument) << unit;
  }
  image.depth_unit_m = 0.0001;
  EXPECT_NO_THROW(image.Validate());
  image.intrinsics.fx = kNan;
  EXPECT_THROW(image.Validate(), std::invalid_argument);
  EXPECT_THROW(DepthImage().Validate(), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
