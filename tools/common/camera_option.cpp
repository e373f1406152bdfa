// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/camera_option.hpp"

#include "fallen/service/channels.hpp"

namespace fallen {

std::string CheckCameraName(const std::string& name) {
  if (channels::IsValidCamera(name)) return "";
  return "got '" + name + "', expected 1 to " + std::to_string(channels::kMaxCameraLength) +
         " letters, digits, '_' or '-'";
}

}  // namespace fallen
