// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/pose_buffer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace fallen {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Eigen::Quaterniond Yaw(double radians) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitZ()));
}

double YawOf(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

TEST(PoseBuffer, EmptyKnowsNothing) {
  const PoseBuffer buffer;
  EXPECT_FALSE(buffer.At(0));
  EXPECT_FALSE(buffer.newest_utime());
}

// A robot that drives at 0.5 m/s and turns at 0.8 rad/s, against the closed form.
TEST(PoseBuffer, InterpolatesConstantMotionExactly) {
  PoseBuffer buffer;
  const std::int64_t start = 1'700'000'000'000'000;
  for (int i = 0; i <= 10; ++i)
    ASSERT_TRUE(buffer.Add(start + i * 100'000, {0.05 * i, -2, 1000}, Yaw(0.08 * i)));
  for (int i = 0; i <= 1000; i += 7) {
    const auto pose = buffer.At(start + i * 1000);
    ASSERT_TRUE(pose) << i;
    EXPECT_TRUE(pose->translation().isApprox(Eigen::Vector3d(0.0005 * i, -2, 1000), 1e-12));
    EXPECT_NEAR(YawOf(*pose), 0.0008 * i, 1e-12);
    EXPECT_TRUE((pose->linear() * pose->linear().transpose()).isIdentity(1e-12));
  }
}

TEST(PoseBuffer, TurnsTheShortWayForQuaternionsOfOppositeSign) {
  PoseBuffer buffer;
  Eigen::Quaterniond second = Yaw(0.2);
  second.coeffs() *= -1;
  ASSERT_TRUE(buffer.Add(0, Eigen::Vector3d::Zero(), Yaw(0)));
  ASSERT_TRUE(buffer.Add(100'000, Eigen::Vector3d::Zero(), second));
  EXPECT_NEAR(YawOf(*buffer.At(50'000)), 0.1, 1e-12);
}

TEST(PoseBuffer, HoldsTheNewestPoseForAShortTimeOnly) {
  PoseBuffer buffer(0.5, 0.1);
  ASSERT_TRUE(buffer.Add(1'000'000, {1, 2, 3}, Yaw(0.3)));
  EXPECT_EQ(buffer.newest_utime(), 1'000'000);
  EXPECT_TRUE(buffer.At(1'000'000)->translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(buffer.At(1'100'000)->translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_FALSE(buffer.At(1'100'001));
  EXPECT_FALSE(buffer.At(999'999));
}

TEST(PoseBuffer, DoesNotInterpolateAcrossAGap) {
  PoseBuffer buffer(0.5, 0.1);
  ASSERT_TRUE(buffer.Add(0, {0, 0, 0}, Yaw(0)));
  ASSERT_TRUE(buffer.Add(600'000, {6, 0, 0}, Yaw(0)));
  EXPECT_EQ(buffer.At(50'000)->translation().x(), 0);
  EXPECT_FALSE(buffer.At(300'000));
  EXPECT_FALSE(buffer.At(599'999));
  EXPECT_EQ(buffer.At(600'000)->translation().x(), 6);
  ASSERT_TRUE(buffer.Add(1'100'000, {11, 0, 0}, Yaw(0)));  // 0.5 s: just near enough
  EXPECT_NEAR(buffer.At(850'000)->translation().x(), 8.5, 1e-12);
}

TEST(PoseBuffer, ClockThatRanBackStartsAnew) {
  PoseBuffer buffer;
  ASSERT_TRUE(buffer.Add(10'000'000, {1, 0, 0}, Yaw(0)));
  ASSERT_TRUE(buffer.Add(2'000'000, {2, 0, 0}, Yaw(0)));
  EXPECT_EQ(buffer.newest_utime(), 2'000'000);
  EXPECT_FALSE(buffer.At(10'000'000));
  EXPECT_EQ(buffer.At(2'000'000)->translation().x(), 2);
}

TEST(PoseBuffer, PoseOfTheSameTimeReplaces) {
  PoseBuffer buffer;
  ASSERT_TRUE(buffer.Add(0, {0, 0, 0}, Yaw(0)));
  ASSERT_TRUE(buffer.Add(100'000, {1, 0, 0}, Yaw(0)));
  ASSERT_TRUE(buffer.Add(100'000, {2, 0, 0}, Yaw(0)));
  EXPECT_EQ(buffer.At(100'000)->translation().x(), 2);
  EXPECT_NEAR(buffer.At(50'000)->translation().x(), 1, 1e-12);
}

TEST(PoseBuffer, RefusesBrokenPosesAndKeepsTheRest) {
  PoseBuffer buffer;
  ASSERT_TRUE(buffer.Add(0, {1, 0, 0}, Yaw(0)));
  EXPECT_FALSE(buffer.Add(-5, {kNan, 0, 0}, Yaw(0)));
  EXPECT_FALSE(buffer.Add(1, {0, std::numeric_limits<double>::infinity(), 0}, Yaw(0)));
  EXPECT_FALSE(buffer.Add(1, {0, 0, 0}, Eigen::Quaterniond(kNan, 0, 0, 1)));
  EXPECT_FALSE(buffer.Add(1, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0)));
  EXPECT_FALSE(buffer.Add(1, {0, 0, 0}, Eigen::Quaterniond(1.01, 0, 0, 0)));
  EXPECT_EQ(buffer.newest_utime(), 0);
  EXPECT_EQ(buffer.At(0)->translation().x(), 1);
}

TEST(PoseBuffer, RoundedQuaternionIsTakenAndNormalised) {
  PoseBuffer buffer;
  ASSERT_TRUE(buffer.Add(0, {0, 0, 0}, Eigen::Quaterniond(1.0005, 0, 0, 0)));
  EXPECT_TRUE(buffer.At(0)->linear().isIdentity(1e-15));
}

TEST(PoseBuffer, KeepsTheNewestTenSeconds) {
  PoseBuffer buffer;
  for (int i = 0; i < 3000; ++i) ASSERT_TRUE(buffer.Add(i * 10'000, {0.001 * i, 0, 0}, Yaw(0)));
  EXPECT_FALSE(buffer.At(1'000'000));
  EXPECT_NEAR(buffer.At(20'000'000)->translation().x(), 2.0, 1e-12);
}

TEST(PoseBuffer, SurvivesExtremeTimes) {
  PoseBuffer buffer;
  ASSERT_TRUE(buffer.Add(std::numeric_limits<std::int64_t>::min(), {1, 0, 0}, Yaw(0)));
  ASSERT_TRUE(buffer.Add(std::numeric_limits<std::int64_t>::max(), {2, 0, 0}, Yaw(0)));
  EXPECT_FALSE(buffer.At(0));
  EXPECT_EQ(buffer.At(std::numeric_limits<std::int64_t>::max())->translation().x(), 2);
}

TEST(PoseBuffer, ConstructorRefusesNonsense) {
  EXPECT_THROW(PoseBuffer(-1, 0.1), std::invalid_argument);
  EXPECT_THROW(PoseBuffer(0.5, kNan), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
