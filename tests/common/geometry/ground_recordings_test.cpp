// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "depth_recording.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/geometry/ground_points.hpp"
#include "synthetic_scene.hpp"

namespace fallen {
namespace {

using testing::kRadPerDeg;
using testing::ReadRecording;
using testing::RecordedFrame;

// Real recordings may not be redistributed: they lie beside the project, or not at all.
std::vector<RecordedFrame> Recording(const std::string& name) {
  return ReadRecording(std::string(FALLEN_SOURCE_DIR) + "/../shared/real/" + name);
}

GroundEstimate Estimate(const DepthImage& image, GroundMethod method,
                        const std::optional<Eigen::Isometry3d>& mounting = std::nullopt) {
  GroundConfig config;
  config.method = method;
  return EstimateGround(image, mounting, config);
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

double AngleBetween(const Plane& a, const Plane& b) {
  return std::acos(std::min(1.0, a.normal.dot(b.normal))) / kRadPerDeg;
}

class Recordings : public ::testing::TestWithParam<GroundMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, Recordings,
                         ::testing::Values(GroundMethod::kAuto, GroundMethod::kRansac,
                                           GroundMethod::kVDisparity),
                         [](const auto& method) { return std::string(EnumName(method.param)); });

TEST_P(Recordings, UrfdCameraIsWhereItsTripodStood) {
  const std::vector<RecordedFrame> frames = Recording("urfd-fall-01");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/urfd-fall-01 is not here";
  std::vector<double> heights;
  std::vector<double> pitches;
  int plausible = 0;
  for (const RecordedFrame& frame : frames) {
    const GroundEstimate estimate = Estimate(frame.image, GetParam());
    if (!estimate.ok()) continue;
    const CameraAttitude attitude = AttitudeOverGround(estimate.plane);
    heights.push_back(attitude.height_m);
    pitches.push_back(attitude.pitch_rad / kRadPerDeg);
    plausible += attitude.height_m >= 0.93 && attitude.height_m <= 0.98 && pitches.back() >= 3 &&
                 pitches.back() <= 4.2;
  }
  ASSERT_GE(heights.size(), 0.95 * static_cast<double>(frames.size()));
  EXPECT_GE(Median(heights), 0.93);
  EXPECT_LE(Median(heights), 0.98);
  EXPECT_GE(Median(pitches), 3);
  EXPECT_LE(Median(pitches), 4);
  EXPECT_GE(plausible, 0.95 * static_cast<double>(frames.size()));
}

TEST_P(Recordings, OfficeFloorIsFoundInEachCapture) {
  const std::vector<RecordedFrame> frames = Recording("pcl-office");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/pcl-office is not here";
  for (const RecordedFrame& frame : frames) {
    const GroundEstimate estimate = Estimate(frame.image, GetParam());
    ASSERT_TRUE(estimate.ok());
    const CameraAttitude attitude = AttitudeOverGround(estimate.plane);
    EXPECT_GE(attitude.height_m, 0.81);
    EXPECT_LE(attitude.height_m, 0.88);
    EXPECT_GE(attitude.pitch_rad / kRadPerDeg, 3);
    EXPECT_LE(attitude.pitch_rad / kRadPerDeg, 5);
  }
}

TEST_P(Recordings, KitchenFloorIsFoundWhereItIsInView) {
  const std::vector<RecordedFrame> frames = Recording("7-scenes-kitchen");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/7-scenes-kitchen is not here";
  for (std::size_t i = 0; i < 13; ++i) {
    const GroundEstimate estimate = Estimate(frames[i].image, GetParam());
    ASSERT_TRUE(estimate.ok()) << i;
    const CameraAttitude attitude = AttitudeOverGround(estimate.plane);
    EXPECT_GE(attitude.height_m, 1.26) << i;
    EXPECT_LE(attitude.height_m, 1.6) << i;
    EXPECT_NEAR(attitude.pitch_rad / kRadPerDeg, 30, 5) << i;
  }
}

// Later frames show counters, cupboards and a table, and often no floor at all. The vertical of the
// ground truth is good to 1 or 2 degrees.
TEST_P(Recordings, KitchenPlanesAreTheFloorOfTheGroundTruth) {
  const std::vector<RecordedFrame> frames = Recording("7-scenes-kitchen");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/7-scenes-kitchen is not here";
  int found = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const GroundEstimate estimate = Estimate(frames[i].image, GetParam());
    if (!estimate.ok()) continue;
    ++found;
    const Plane truth = TransformPlane(frames[i].T_world_camera.value().inverse(), Plane{});
    EXPECT_LE(AngleBetween(estimate.plane, truth), 4) << i;
    EXPECT_NEAR(estimate.plane.offset, truth.offset, 0.08) << i;
  }
  EXPECT_GE(found, 35);
}

// What is taken away as floor: points lower than 0.04 m + 0.003 z^2.
TEST_P(Recordings, UrfdFloorStaysBelowTheClearance) {
  const std::vector<RecordedFrame> frames = Recording("urfd-fall-01");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/urfd-fall-01 is not here";
  constexpr double kFloorHeight_m = 0.10;
  constexpr int kAllPixels = 640 * 480;
  int floor_points = 0;
  int residue = 0;
  for (std::size_t i = 0; i < frames.size(); i += 10) {
    const GroundEstimate estimate = Estimate(frames[i].image, GetParam());
    ASSERT_TRUE(estimate.ok());
    for (const GroundPoint& point : SampleGroundPoints(frames[i].image, kAllPixels)) {
      const double height = estimate.plane.SignedHeight(point.position.cast<double>());
      const double z = point.position.z();
      if (std::abs(height) > kFloorHeight_m || z > 5 ||
          estimate.plane.normal.dot(point.normal.cast<double>()) < 0.8)
        continue;
      ++floor_points;
      residue += height > 0.04 + 0.003 * z * z;
    }
  }
  EXPECT_GT(floor_points, 300'000);
  EXPECT_LT(residue, 0.002 * floor_points);
}

TEST(RecordedMounting, IsCorrectedByTheImage) {
  const std::vector<RecordedFrame> frames = Recording("urfd-fall-01");
  if (frames.empty()) GTEST_SKIP() << "../shared/real/urfd-fall-01 is not here";
  for (std::size_t i = 0; i < frames.size(); i += 10) {
    const GroundEstimate estimate =
        Estimate(frames[i].image, GroundMethod::kAuto, testing::CameraPose(0.90, 6.5, 2.0));
    EXPECT_EQ(estimate.method, GroundMethod::kRansac);
    const CameraAttitude attitude = AttitudeOverGround(estimate.plane);
    EXPECT_NEAR(attitude.height_m, 0.955, 0.025);
    EXPECT_NEAR(attitude.pitch_rad / kRadPerDeg, 3.6, 0.6);
    EXPECT_NEAR(attitude.roll_rad / kRadPerDeg, 3.6, 0.6);
  }
}

}  // namespace
}  // namespace fallen
