// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/camera_checks.hpp"

#include <filesystem>

#include "services/depth_capture/openni_session.hpp"

namespace fallen {
namespace {

constexpr char kListRemedy[] = "plug it in, then: fallen-depth-capture --list";

Finding JudgeCamera(const CameraInfo& camera) {
  const std::string name = camera.vendor + " " + camera.name + " (" + camera.uri + ")";
  if (camera.problem.empty()) return Good("camera", name + ": " + ToString(camera.modes));
  return {"camera", Verdict::kWarning, name + ": " + camera.problem,
          "sudo udevadm trigger --subsystem-match=usb, or unplug it and plug it in again"};
}

Finding JudgeConfigured(const std::string& uri, const std::vector<CameraInfo>& cameras) {
  if (cameras.empty())
    return {"camera", Verdict::kWarning, "none is plugged in, needed for live pictures",
            kListRemedy};
  for (const CameraInfo& camera : cameras)
    if (uri.empty() || camera.uri == uri) return Good("configured camera", camera.uri);
  return {"configured camera", Verdict::kWarning, uri + " is not among those plugged in",
          kListRemedy};
}

}  // namespace

std::vector<Finding> CheckCameras(const std::string& device_uri) {
  std::vector<Finding> findings;
  try {
    const OpenNiSession session;
    findings.push_back(Good("OpenNI2", "has drivers"));
    const std::vector<CameraInfo> cameras = ListCameras(session);
    for (const CameraInfo& camera : cameras) findings.push_back(JudgeCamera(camera));
    if (std::filesystem::path(device_uri).extension() != ".oni")
      findings.push_back(JudgeConfigured(device_uri, cameras));
  } catch (const std::exception& error) {
    findings.push_back({"OpenNI2", Verdict::kWarning, error.what(),
                        "sudo apt-get install -y --reinstall libopenni2-0"});
  }
  return findings;
}

}  // namespace fallen
