// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

void Check(const header_t& message) {
  checks::InRange("header_t.utime", message.utime, 0, limits::kMaxTime);
  checks::InRange("header_t.seq", message.seq, 0, limits::kMaxTime);
  checks::CheckText("header_t.sensor_name", message.sensor_name, limits::kMaxNameBytes);
}

void Check(const pose_t& message) {
  checks::InRange("pose_t.utime", message.utime, 0, limits::kMaxTime);
  for (const double coordinate : message.pos)
    checks::InRange("pose_t.pos", coordinate, -limits::kMaxCoordinate_m, limits::kMaxCoordinate_m);
  checks::UnitQuaternion("pose_t.orientation", message.orientation);
}

}  // namespace

header_t ToMessage(const Header& value) {
  header_t message{};
  message.utime = value.utime;
  message.seq = value.seq;
  message.sensor_name = value.sensor_name;
  Check(message);
  return message;
}

Header FromMessage(const header_t& message) {
  Check(message);
  return {message.utime, message.seq, message.sensor_name};
}

pose_t ToMessage(const StampedPose& value) {
  pose_t message{};
  message.utime = value.utime;
  std::copy_n(value.translation.data(), 3, message.pos);
  message.orientation[0] = value.rotation.w();
  message.orientation[1] = value.rotation.x();
  message.orientation[2] = value.rotation.y();
  message.orientation[3] = value.rotation.z();
  Check(message);
  return message;
}

StampedPose FromMessage(const pose_t& message) {
  Check(message);
  const auto& wxyz = message.orientation;
  return {message.utime,
          {message.pos[0], message.pos[1], message.pos[2]},
          {wxyz[0], wxyz[1], wxyz[2], wxyz[3]}};
}

}  // namespace fallen
