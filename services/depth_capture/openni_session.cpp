// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/openni_session.hpp"

#include <OpenNI.h>

#include <stdexcept>

#include "services/depth_capture/openni_conversions.hpp"

namespace fallen {

OpenNiSession::OpenNiSession() {
  if (openni::OpenNI::initialize() == openni::STATUS_OK) return;
  const std::string reason = OpenNiError("no reason given");
  // A start that failed counts as a start all the same: without this the next one would be told
  // that all is well, and find no drivers.
  openni::OpenNI::shutdown();
  throw std::runtime_error("OpenNI2 cannot start: " + reason);
}

OpenNiSession::~OpenNiSession() { openni::OpenNI::shutdown(); }

std::vector<CameraInfo> ListCameras(const OpenNiSession&) {
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<CameraInfo> cameras;
  for (int i = 0; i < devices.getSize(); ++i) {
    CameraInfo camera;
    camera.uri = devices[i].getUri();
    camera.vendor = devices[i].getVendor();
    camera.name = devices[i].getName();
    openni::Device device;
    if (device.open(camera.uri.c_str()) != openni::STATUS_OK) {
      camera.problem = OpenNiError("cannot be opened");
    } else {
      camera.modes = DepthModesOf(device);
      if (camera.modes.empty()) camera.problem = "has no depth sensor";
      device.close();
    }
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace fallen
