// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/depth_mode.hpp"

#include <algorithm>

namespace fallen {

std::string ToString(const DepthMode& mode) {
  return std::to_string(mode.width) + "x" + std::to_string(mode.height) + " " +
         std::to_string(mode.rate_hz) + " Hz " + std::string(EnumName(mode.unit));
}

std::string ToString(std::span<const DepthMode> modes) {
  std::string text;
  for (const DepthMode& mode : modes) text += (text.empty() ? "" : ", ") + ToString(mode);
  return text;
}

void RequireSupported(const std::string& camera, const DepthMode& wanted,
                      std::span<const DepthMode> offered) {
  if (std::find(offered.begin(), offered.end(), wanted) != offered.end()) return;
  throw UnsupportedMode(camera + ": mode: got " + ToString(wanted) + ", expected one of " +
                        (offered.empty() ? "none: it has no depth modes" : ToString(offered)));
}

}  // namespace fallen
