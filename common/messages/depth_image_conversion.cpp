// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

// A unit of depth: OpenNI's finest is 0.1 mm; one of a metre would leave no picture.
constexpr double kMaxDepthUnit_m = 1;

// All but the image itself.
void Check(const depth_image_t& message) {
  checks::InRange("depth_image_t.width", message.width, 1, limits::kMaxImageSide);
  checks::InRange("depth_image_t.height", message.height, 1, limits::kMaxImageSide);
  checks::Positive("depth_image_t.fx", message.fx);
  checks::Positive("depth_image_t.fy", message.fy);
  checks::Finite("depth_image_t.cx", message.cx);
  checks::Finite("depth_image_t.cy", message.cy);
  checks::Positive("depth_image_t.depth_unit_m", message.depth_unit_m);
  checks::InRange("depth_image_t.depth_unit_m", message.depth_unit_m, 0.0, kMaxDepthUnit_m);
  if (checks::Boolean("depth_image_t.has_mounting", message.has_mounting)) {
    for (const double coordinate : message.mounting_position)
      checks::InRange("depth_image_t.mounting_position", coordinate, -limits::kMaxMounting_m,
                      limits::kMaxMounting_m);
    checks::UnitQuaternion("depth_image_t.mounting_orientation", message.mounting_orientation);
  }
  checks::InRange("depth_image_t.compression", message.compression, depth_image_t::COMPRESSION_NONE,
                  depth_image_t::COMPRESSION_RANKS);
  checks::Count("depth_image_t.size", message.size, message.data.size());
}

void SetMounting(depth_image_t& message, const Eigen::Isometry3d& T_robot_camera) {
  message.has_mounting = 1;
  const Eigen::Vector3d position = T_robot_camera.translation();
  std::copy_n(position.data(), 3, message.mounting_position);
  const Eigen::Quaterniond orientation(T_robot_camera.linear());
  message.mounting_orientation[0] = orientation.w();
  message.mounting_orientation[1] = orientation.x();
  message.mounting_orientation[2] = orientation.y();
  message.mounting_orientation[3] = orientation.z();
}

Eigen::Isometry3d MountingFromMessage(const depth_image_t& message) {
  Eigen::Isometry3d T_robot_camera = Eigen::Isometry3d::Identity();
  T_robot_camera.translation() = Eigen::Map<const Eigen::Vector3d>(message.mounting_position);
  const auto& wxyz = message.mounting_orientation;
  const Eigen::Quaterniond orientation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  T_robot_camera.linear() = orientation.normalized().toRotationMatrix();
  return T_robot_camera;
}

}  // namespace

depth_image_t ToMessage(const StampedDepthImage& value, DepthCompression compression) {
  const CameraIntrinsics& intrinsics = value.image.intrinsics;
  depth_image_t message{};
  message.header = ToMessage(value.header);
  message.width = intrinsics.width;
  message.height = intrinsics.height;
  message.fx = intrinsics.fx;
  message.fy = intrinsics.fy;
  message.cx = intrinsics.cx;
  message.cy = intrinsics.cy;
  message.depth_unit_m = value.image.depth_unit_m;
  if (value.T_robot_camera) SetMounting(message, *value.T_robot_camera);
  Check(message);
  const std::size_t pixels = static_cast<std::size_t>(message.width) * message.height;
  if (value.image.depth.size() != pixels)
    checks::Fail("depth_image_t.data", std::to_string(value.image.depth.size()) + " pixels",
                 std::to_string(pixels));
  EncodedDepth encoded = EncodeDepth(value.image.depth, message.width, compression);
  message.compression = static_cast<std::int8_t>(encoded.compression);
  message.size = static_cast<std::int32_t>(encoded.bytes.size());
  message.data = std::move(encoded.bytes);
  return message;
}

StampedDepthImage FromMessage(const depth_image_t& message) {
  StampedDepthImage value;
  value.header = FromMessage(message.header);
  Check(message);
  value.image.intrinsics = {message.width, message.height, message.fx,
                            message.fy,    message.cx,     message.cy};
  value.image.depth_unit_m = message.depth_unit_m;
  value.image.depth = DecodeDepth(message.data, static_cast<DepthCompression>(message.compression),
                                  message.width, message.height);
  if (message.has_mounting != 0) value.T_robot_camera = MountingFromMessage(message);
  return value;
}

}  // namespace fallen
