// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/synthetic_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"

namespace fallen::testing_support {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr double kFocal_px = 285;  // a PrimeSense camera at half size
constexpr double kTilt_rad = 20 * std::numbers::pi / 180;
constexpr double kMaxDepth_m = 8;
constexpr std::int64_t kPoseInterval_us = 20'000;

const Eigen::Vector3d kBodyCenter_world(2.4, 0.1, 0.14);
const Eigen::Vector3d kBodyRadii(0.3, 0.85, 0.14);

/// Distance along a ray, in units of its direction, to the floor; infinite above the horizon.
double HitFloor(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  return direction.z() < 0 ? -origin.z() / direction.z() : INFINITY;
}

double HitBody(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  // In coordinates in which the ellipsoid is the unit sphere.
  const Eigen::Vector3d o = (origin - kBodyCenter_world).cwiseQuotient(kBodyRadii);
  const Eigen::Vector3d d = direction.cwiseQuotient(kBodyRadii);
  const double a = d.squaredNorm();
  const double b = o.dot(d);
  const double discriminant = b * b - a * (o.squaredNorm() - 1);
  return discriminant < 0 ? INFINITY : (-b - std::sqrt(discriminant)) / a;
}

}  // namespace

Eigen::Isometry3d SceneMounting() {
  Eigen::Matrix3d R_robot_level;  // optical axes (right, down, forward) seen from the robot
  R_robot_level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T_robot_camera = Eigen::Isometry3d::Identity();
  T_robot_camera.linear() =
      Eigen::AngleAxisd(kTilt_rad, Eigen::Vector3d::UnitY()).toRotationMatrix() * R_robot_level;
  T_robot_camera.translation() = Eigen::Vector3d(0.1, 0, 0.95);
  return T_robot_camera;
}

StampedPose ScenePose(std::int64_t utime) {
  const double t_s = static_cast<double>(utime - kFirstUtime) * 1e-6;
  StampedPose pose;
  pose.utime = utime;
  pose.translation = Eigen::Vector3d(0.3 * t_s, 0.02 * t_s, 0);
  pose.rotation = Eigen::AngleAxisd(0.05 * t_s, Eigen::Vector3d::UnitZ());
  return pose;
}

StampedDepthImage SceneImage(std::int64_t seq, const std::string& camera) {
  StampedDepthImage stamped;
  stamped.header = {kFirstUtime + seq * kFrameInterval_us, seq, camera};
  stamped.T_robot_camera = SceneMounting();
  DepthImage& image = stamped.image;
  image.intrinsics = {
      kWidth, kHeight, kFocal_px, kFocal_px, (kWidth - 1) / 2.0, (kHeight - 1) / 2.0};
  image.depth.resize(static_cast<std::size_t>(kWidth) * kHeight);

  const StampedPose pose = ScenePose(stamped.header.utime);
  Eigen::Isometry3d T_world_robot = Eigen::Isometry3d::Identity();
  T_world_robot.linear() = pose.rotation.toRotationMatrix();
  T_world_robot.translation() = pose.translation;
  const Eigen::Isometry3d T_world_camera = T_world_robot * SceneMounting();
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      // A ray of depth 1: distances along it are depths.
      const Eigen::Vector3d ray = T_world_camera.linear() * image.intrinsics.Deproject(u, v, 1);
      const double depth_m = std::min(HitFloor(T_world_camera.translation(), ray),
                                      HitBody(T_world_camera.translation(), ray));
      if (depth_m > 0 && depth_m < kMaxDepth_m)
        image.depth[static_cast<std::size_t>(v * kWidth + u)] =
            static_cast<std::uint16_t>(std::lround(depth_m / image.depth_unit_m));
    }
  return stamped;
}

void WriteSceneLog(const std::filesystem::path& path, int frames) {
  LogWriter log(path);
  std::int64_t pose_utime = kFirstUtime;
  for (int seq = 0; seq < frames; ++seq) {
    const StampedDepthImage image = SceneImage(seq);
    for (; pose_utime <= image.header.utime; pose_utime += kPoseInterval_us)
      log.Write(pose_utime, channels::kRobotPose, EncodeMessage(ToMessage(ScenePose(pose_utime))));
    log.Write(image.header.utime, channels::Depth(image.header.sensor_name),
              EncodeMessage(ToMessage(image)));
  }
  log.Close();
}

}  // namespace fallen::testing_support
