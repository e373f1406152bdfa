// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/temporary_folder.hpp"
#include "tests/virtual_camera/virtual_pattern.hpp"

namespace fallen::test {

/// Steers the virtual cameras of this process and of those that it starts.
class VirtualCameraControl {
 public:
  explicit VirtualCameraControl(const std::string& state = "plugged") {
    Set(state);
    setenv(virtual_camera::kControlVariable, (folder_ / "control").c_str(), 1);
    unsetenv(virtual_camera::kFramesVariable);
    unsetenv(virtual_camera::kCountVariable);
    unsetenv(virtual_camera::kHotplugVariable);
  }

  /// By renaming, so that the driver never reads half a word.
  void Set(const std::string& state) const {
    std::ofstream(folder_ / "next") << state << '\n';
    std::filesystem::rename(folder_ / "next", folder_ / "control");
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace fallen::test
