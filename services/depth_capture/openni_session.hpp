// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "services/depth_capture/depth_mode.hpp"

/// The OpenNI2 library and the cameras that it sees.
namespace fallen {

/// Keeps the library started. May be nested: the last one to go shuts it down.
///
/// Starting loads the drivers and looks for cameras; so shutting down and starting anew finds a
/// camera also where nothing announces it (in a container without udev, say).
class OpenNiSession {
 public:
  /// @throws std::runtime_error if OpenNI2 finds no driver that works.
  OpenNiSession();
  ~OpenNiSession();
  OpenNiSession(const OpenNiSession&) = delete;
  OpenNiSession& operator=(const OpenNiSession&) = delete;
};

struct CameraInfo {
  std::string uri;
  std::string vendor;
  std::string name;
  std::vector<DepthMode> modes;  ///< of the depth sensor; empty if it has none or cannot be opened
  std::string problem;           ///< why there are no modes, "" if there are
};

/// Cameras that are plugged in now, with their depth modes in the driver's order.
std::vector<CameraInfo> ListCameras(const OpenNiSession& session);

}  // namespace fallen
