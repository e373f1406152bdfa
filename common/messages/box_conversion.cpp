// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/box_conversion.hpp"

#include <algorithm>
#include <string>

#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {

box_t BoxToMessage(std::string_view field, const OrientedBox& box) {
  box_t message{};
  std::copy_n(box.center.data(), 3, message.center);
  std::copy_n(box.size.data(), 3, message.size);
  message.yaw = box.yaw;
  BoxFromMessage(field, message);
  return message;
}

OrientedBox BoxFromMessage(std::string_view field, const box_t& message) {
  const std::string name(field);
  for (int axis = 0; axis < 3; ++axis) {
    checks::InRange(name + ".center", message.center[axis], -limits::kMaxCoordinate_m,
                    limits::kMaxCoordinate_m);
    checks::InRange(name + ".size", message.size[axis], 0.0, limits::kMaxCoordinate_m);
  }
  checks::Finite(name + ".yaw", message.yaw);
  return {Eigen::Vector3d(message.center), Eigen::Vector3d(message.size), message.yaw};
}

}  // namespace fallen
