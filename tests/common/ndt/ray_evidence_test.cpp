// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ray_evidence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fallen {
namespace {

constexpr double kCellSize = 0.05;
const Eigen::Vector3d kMean(0, 0, 2);
// Spread evenly over a cell across the view, 2 mm along it; and the same seen at a grazing angle.
const SymmetricMatrix3 kFacing = {2e-4, 0, 0, 2e-4, 0, 4e-6};
const SymmetricMatrix3 kGrazing = {2e-4, 0, 0, 4e-6, 0, 2e-4};

DepthImage FlatImage(double depth_m) {
  DepthImage image;
  image.intrinsics = {640, 480, 575, 575, 320, 240};
  image.depth.assign(640 * 480, static_cast<std::uint16_t>(depth_m * 1000));
  return image;
}

double RaysThrough(double depth_m, const SymmetricMatrix3& covariance) {
  return CountRaysThrough(FlatImage(depth_m), kMean, covariance, kCellSize);
}

TEST(RayEvidence, RaysThatEndWellBehindCount) {
  // The ray through the mean counts 1. The four others lie 3 pixels, 10.4 mm off, where the
  // Gaussian of 14.2 mm is down to exp(-0.27) = 0.76.
  EXPECT_NEAR(RaysThrough(4, kFacing), 1 + 4 * 0.76, 0.05);
  EXPECT_NEAR(RaysThrough(2.2, kFacing), 1 + 4 * 0.76, 0.05);
}

TEST(RayEvidence, RaysThatEndInFrontOrAtTheCellDoNot) {
  EXPECT_EQ(RaysThrough(1.0, kFacing), 0);
  EXPECT_EQ(RaysThrough(1.99, kFacing), 0);
  EXPECT_EQ(RaysThrough(2.0, kFacing), 0);
  EXPECT_EQ(RaysThrough(2.01, kFacing), 0) << "within two deviations of the noise";
}

TEST(RayEvidence, GrowsWithTheDistanceBehind) {
  double last = 0;
  for (double depth_m = 2.0; depth_m < 2.2; depth_m += 0.005) {
    const double rays = RaysThrough(depth_m, kFacing);
    EXPECT_GE(rays, last);
    last = rays;
  }
}

// Along the surface a pixel's width is many centimetres of depth: it takes that much to be behind.
TEST(RayEvidence, GrazingRaysNeedToEndFartherBehind) {
  EXPECT_GT(RaysThrough(2.04, kFacing), 0.5);
  EXPECT_EQ(RaysThrough(2.02, kGrazing), 0);
  EXPECT_LT(RaysThrough(2.04, kGrazing), RaysThrough(2.04, kFacing));
}

// Rays above and below the edge-on cell miss it; those within its plane go through.
TEST(RayEvidence, RaysThatMissTheGaussianDoNotCount) {
  EXPECT_NEAR(RaysThrough(4, kGrazing), 1 + 2 * 0.76, 0.05);
}

TEST(RayEvidence, PixelsWithoutDepthDoNotCount) { EXPECT_EQ(RaysThrough(0, kFacing), 0); }

TEST(RayEvidence, PixelsBesideSomethingNearerDoNotCount) {
  DepthImage image = FlatImage(4);
  for (int u = 0; u < 640; ++u) image.depth[241 * 640 + u] = 2000;  // below the row of the mean
  // Rows 240 and 241 + 2 touch it; of the five rays, those at rows 237 and 243 are free of it.
  EXPECT_NEAR(CountRaysThrough(image, kMean, kFacing, kCellSize), 2 * 0.76, 0.05);
}

TEST(RayEvidence, OutsideTheImageThereIsNone) {
  const DepthImage image = FlatImage(4);
  EXPECT_EQ(CountRaysThrough(image, {5, 0, 2}, kFacing, kCellSize), 0);
  EXPECT_EQ(CountRaysThrough(image, {0, -5, 2}, kFacing, kCellSize), 0);
  EXPECT_EQ(CountRaysThrough(image, {0, 0, -2}, kFacing, kCellSize), 0);
  EXPECT_EQ(CountRaysThrough(image, {0, 0, 1e-12}, kFacing, kCellSize), 0);
  // At the rim, the rays that are still in the image count.
  const Eigen::Vector3d rim = image.intrinsics.Deproject(639, 240, 2);
  EXPECT_GT(CountRaysThrough(image, rim, kFacing, kCellSize), 1);
}

TEST(RayEvidence, DegenerateGaussiansHaveEvidenceToo) {
  EXPECT_GE(RaysThrough(4, SymmetricMatrix3{}), 0.9);
  EXPECT_LE(RaysThrough(4, SymmetricMatrix3{}), kRaysPerVoxel);
}

TEST(RayEvidence, TheCentreIsPassedOnlyWellBehind) {
  EXPECT_TRUE(RayPassesCenter(FlatImage(2.2), kMean, kCellSize));
  EXPECT_FALSE(RayPassesCenter(FlatImage(2.04), kMean, kCellSize));
  EXPECT_FALSE(RayPassesCenter(FlatImage(1.5), kMean, kCellSize));
  EXPECT_FALSE(RayPassesCenter(FlatImage(0), kMean, kCellSize));
  EXPECT_FALSE(RayPassesCenter(FlatImage(4), {0, 0, -1}, kCellSize));
}

}  // namespace
}  // namespace fallen
