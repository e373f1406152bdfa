// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/camera_checks.hpp"

// In place of camera_checks.cpp where OpenNI2 is missing.
namespace fallen {

std::vector<Finding> CheckCameras(const std::string&) {
  return {
      {"OpenNI2", Verdict::kWarning,
       "missing when this was built, needed for live pictures and .oni recordings",
       "sudo apt-get install -y libopenni2-dev && cmake --preset release && cmake --build --preset "
       "release"}};
}

}  // namespace fallen
