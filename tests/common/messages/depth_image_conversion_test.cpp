// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "fallen/messages/conversions.hpp"

namespace fallen {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

StampedDepthImage Sample() {
  StampedDepthImage value;
  value.header = {1'700'000'000'123'456, 42, "FRONT"};
  value.image.intrinsics = {8, 6, 525.5, 526.25, 3.5, 2.5};
  value.image.depth_unit_m = 1e-4;
  for (int i = 0; i < 48; ++i) value.image.depth.push_back(static_cast<std::uint16_t>(i * 1000));
  Eigen::Isometry3d mounting = Eigen::Isometry3d::Identity();
  mounting.linear() = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) *
                       Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()))
                          .toRotationMatrix();
  mounting.translation() << 0.1, -0.2, 0.95;
  value.T_robot_camera = mounting;
  return value;
}

TEST(DepthImageConversion, RoundTripKeepsEverything) {
  const StampedDepthImage value = Sample();
  const StampedDepthImage back = FromMessage(ToMessage(value));
  EXPECT_EQ(back.header, value.header);
  EXPECT_EQ(back.image.intrinsics, value.image.intrinsics);
  EXPECT_EQ(back.image.depth_unit_m, value.image.depth_unit_m);
  EXPECT_EQ(back.image.depth, value.image.depth);
  ASSERT_TRUE(back.T_robot_camera);
  EXPECT_EQ(back.T_robot_camera->translation(), value.T_robot_camera->translation());
  EXPECT_LT((back.T_robot_camera->matrix() - value.T_robot_camera->matrix()).norm(), 1e-14);
}

TEST(DepthImageConversion, AMountingThatIsNotKnownStaysUnknown) {
  StampedDepthImage value = Sample();
  value.T_robot_camera.reset();
  EXPECT_FALSE(FromMessage(ToMessage(value)).T_robot_camera);
}

TEST(DepthImageConversion, EveryCompressionIsReadable) {
  for (const auto& [compression, name] : EnumNames(DepthCompression{})) {
    const depth_image_t message = ToMessage(Sample(), compression);
    EXPECT_EQ(message.compression, static_cast<std::int8_t>(compression));
    EXPECT_EQ(FromMessage(message).image.depth, Sample().image.depth) << name;
  }
}

TEST(DepthImageConversion, RefusesEachBadField) {
  const std::pair<const char*, std::function<void(depth_image_t&)>> cases[] = {
      {"header_t.utime", [](auto& m) { m.header.utime = -1; }},
      {"header_t.seq", [](auto& m) { m.header.seq = std::numeric_limits<std::int64_t>::max(); }},
      {"header_t.sensor_name", [](auto& m) { m.header.sensor_name = std::string(64, 'A'); }},
      {"header_t.sensor_name", [](auto& m) { m.header.sensor_name = "A\x01"; }},
      {"depth_image_t.width", [](auto& m) { m.width = 0; }},
      {"depth_image_t.width", [](auto& m) { m.width = 8193; }},
      {"depth_image_t.height", [](auto& m) { m.height = -6; }},
      {"depth_image_t.data", [](auto& m) { m.height = 7; }},
      {"depth_image_t.fx", [](auto& m) { m.fx = 0; }},
      {"depth_image_t.fy", [](auto& m) { m.fy = kNan; }},
      {"depth_image_t.cx", [](auto& m) { m.cx = HUGE_VAL; }},
      {"depth_image_t.cy", [](auto& m) { m.cy = kNan; }},
      {"depth_image_t.depth_unit_m", [](auto& m) { m.depth_unit_m = 0; }},
      {"depth_image_t.depth_unit_m", [](auto& m) { m.depth_unit_m = 2; }},
      {"depth_image_t.has_mounting", [](auto& m) { m.has_mounting = -1; }},
      {"depth_image_t.has_mounting", [](auto& m) { m.has_mounting = 2; }},
      {"depth_image_t.mounting_position", [](auto& m) { m.mounting_position[1] = kNan; }},
      {"depth_image_t.mounting_orientation", [](auto& m) { m.mounting_orientation[0] = 5; }},
      {"depth_image_t.mounting_orientation", [](auto& m) { m.mounting_orientation[3] = kNan; }},
      {"depth_image_t.compression", [](auto& m) { m.compression = 5; }},
      {"depth_image_t.compression", [](auto& m) { m.compression = -128; }},
      {"depth_image_t.size", [](auto& m) { m.size += 1; }},
      {"depth_image_t.data", [](auto& m) { m.data.resize(3), m.size = 3; }},
      {"depth_image_t.data", [](auto& m) { m.data.clear(), m.size = 0; }},
  };
  for (const auto& [field, spoil] : cases) {
    depth_image_t message = ToMessage(Sample());
    spoil(message);
    try {
      FromMessage(message);
      ADD_FAILURE() << field << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(field));
      EXPECT_THAT(error.what(),
                  testing::AllOf(testing::HasSubstr(": got "), testing::HasSubstr(", expected ")));
    }
  }
}

TEST(DepthImageConversion, WritingChecksToo) {
  StampedDepthImage value = Sample();
  value.image.depth.pop_back();
  EXPECT_THROW(ToMessage(value), std::invalid_argument);
  value = Sample();
  value.image.intrinsics.fx = -1;
  EXPECT_THROW(ToMessage(value), std::invalid_argument);
}

TEST(PoseConversion, RoundTripIsExact) {
  const StampedPose value{1'700'000'000'000'001, {1.1, -2.2, 3.3}, {0.5, -0.5, 0.5, 0.5}};
  const StampedPose back = FromMessage(ToMessage(value));
  EXPECT_EQ(back.utime, value.utime);
  EXPECT_EQ(back.translation, value.translation);
  EXPECT_EQ(back.rotation.coeffs(), value.rotation.coeffs());
}

TEST(PoseConversion, HasTheHashOfBotCore) {
  // lcm-gen writes 0x170b77d82958082f into bot_core's pose_t; on the wire it is rotated by one bit.
  EXPECT_EQ(pose_t::getHash(), std::int64_t{0x170b77d82958082f} << 1);
}

TEST(PoseConversion, RefusesEachBadField) {
  const StampedPose value{0, {1, 2, 3}, {1, 0, 0, 0}};
  pose_t message = ToMessage(value);
  message.utime = -5;
  EXPECT_THROW(FromMessage(message), std::invalid_argument);
  message = ToMessage(value);
  message.pos[2] = kNan;
  EXPECT_THROW(FromMessage(message), std::invalid_argument);
  message = ToMessage(value);
  message.pos[2] = 1e9;
  EXPECT_THROW(FromMessage(message), std::invalid_argument);
  message = ToMessage(value);
  message.orientation[0] = 0;
  EXPECT_THROW(FromMessage(message), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
