// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/camera_view_conversion.hpp"

#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {

camera_view_t ViewToMessage(const std::string& field, const CameraView& view) {
  camera_view_t message{};
  message.width = view.intrinsics.width;
  message.height = view.intrinsics.height;
  message.fx = view.intrinsics.fx;
  message.fy = view.intrinsics.fy;
  message.cx = view.intrinsics.cx;
  message.cy = view.intrinsics.cy;
  message.depth_mm.assign(view.depth_mm.begin(), view.depth_mm.end());
  message.count = static_cast<std::int32_t>(message.depth_mm.size());
  ViewFromMessage(field, message);
  return message;
}

CameraView ViewFromMessage(const std::string& field, const camera_view_t& message) {
  CameraView view;
  if (message.width == 0 && message.height == 0 && message.count == 0) {
    checks::Count(field + ".count", message.count, message.depth_mm.size());
    return view;
  }
  checks::InRange(field + ".width", message.width, 1, limits::kMaxImageSide);
  checks::InRange(field + ".height", message.height, 1, limits::kMaxImageSide);
  checks::Positive(field + ".fx", message.fx);
  checks::Positive(field + ".fy", message.fy);
  checks::Finite(field + ".cx", message.cx);
  checks::Finite(field + ".cy", message.cy);
  checks::Count(field + ".count", message.count, message.depth_mm.size());
  const std::int64_t blocks = std::int64_t{message.width} * message.height;
  checks::InRange(field + ".count", message.count, blocks, blocks);
  const std::string depth_field = field + ".depth_mm";
  for (const std::int16_t depth : message.depth_mm)
    checks::InRange(depth_field, depth, 0, kMaxViewDepth_mm);
  view.intrinsics = {message.width, message.height, message.fx, message.fy, message.cx, message.cy};
  view.depth_mm.assign(message.depth_mm.begin(), message.depth_mm.end());
  return view;
}

}  // namespace fallen
