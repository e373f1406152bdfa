// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/tools/common/lying_scene.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "tests/tools/common/grey_png.hpp"

namespace fallen::lying_scene {
namespace {

constexpr CameraIntrinsics kCamera{320, 240, 285, 285, 159.5, 119.5};
constexpr double kPitch = 15 * std::numbers::pi / 180;
constexpr double kWallX = 3.5;
constexpr double kDepthUnitM = 0.001;

/// Where a ray from `origin` first meets the floor, the wall or the block; in units of `ray`.
double Cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray, With with) {
  double nearest = std::numeric_limits<double>::infinity();
  if (ray.z() < 0) nearest = -origin.z() / ray.z();
  if (ray.x() > 0) nearest = std::min(nearest, (kWallX - origin.x()) / ray.x());
  if (with == With::kNobody) return nearest;

  const OrientedBox box = Person();
  const Eigen::AngleAxisd to_box(-box.yaw, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d from = to_box * (origin - box.center);
  const Eigen::Vector3d along = to_box * ray;
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (-box.size[axis] / 2 - from[axis]) / along[axis];
    const double b = (box.size[axis] / 2 - from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? std::min(nearest, enter) : nearest;
}

}  // namespace

OrientedBox Person() { return {{2.0, 0.1, 0.15}, {0.45, 1.6, 0.3}, 0.3}; }

Eigen::Isometry3d CameraPose(double robot_x) {
  Eigen::Matrix3d level;  // x ahead, y left, z up <- x right, y down, z ahead
  level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() =
      Eigen::AngleAxisd(kPitch, Eigen::Vector3d::UnitY()).toRotationMatrix() * level;
  T_world_camera.translation() << robot_x, 0, kCameraHeightM;
  return T_world_camera;
}

Frame Render(std::int64_t utime, double robot_x, With with) {
  Frame frame;
  frame.utime = utime;
  frame.sensor_name = "CAMERA";
  frame.image.intrinsics = kCamera;
  frame.image.depth_unit_m = kDepthUnitM;
  const Eigen::Isometry3d T_world_camera = CameraPose(robot_x);
  for (int v = 0; v < kCamera.height; ++v)
    for (int u = 0; u < kCamera.width; ++u) {
      const Eigen::Vector3d ray = T_world_camera.linear() * kCamera.Deproject(u, v, 1);
      const double z_m = Cast(T_world_camera.translation(), ray, with);
      const bool is_measured = z_m > 0.4 && z_m < 6;
      frame.image.depth.push_back(
          is_measured ? static_cast<std::uint16_t>(std::lround(z_m / kDepthUnitM)) : 0);
    }
  frame.T_world_robot = Eigen::Isometry3d(Eigen::Translation3d(robot_x, 0, 0));
  frame.T_robot_camera = CameraPose(0);
  return frame;
}

void WriteDirectory(const std::filesystem::path& directory, int frames, With with,
                    bool with_poses) {
  std::filesystem::create_directories(directory / "depth");
  std::ofstream(directory / "camera.yaml")
      << "width: 320\nheight: 240\nfx: 285\nfy: 285\ncx: 159.5\ncy: 119.5\ndepth_scale: 0.001\n";
  std::ofstream table(directory / "depth.txt");
  std::ofstream poses;
  if (with_poses) poses.open(directory / "groundtruth.txt");
  poses.precision(17);
  for (int i = 0; i < frames; ++i) {
    const double robot_x = 0.02 * i;
    const std::string name = "depth/" + std::to_string(i) + ".png";
    const double time = 1 + 0.1 * i;
    WriteGreyPng(directory / name, kCamera.width, kCamera.height,
                 Render(0, robot_x, with).image.depth);
    table << time << ' ' << name << '\n';
    const Eigen::Isometry3d T = CameraPose(robot_x);
    const Eigen::Quaterniond q(T.linear());
    const Eigen::Vector3d p = T.translation();
    poses << time << ' ' << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << q.x() << ' ' << q.y()
          << ' ' << q.z() << ' ' << q.w() << '\n';
  }
}

void WriteLabels(const std::filesystem::path& directory, With with) {
  std::ofstream labels(directory / "labels.yaml");
  if (with == With::kNobody) {
    labels << "person:\n  present: false\n";
    return;
  }
  const OrientedBox box = Person();
  labels << "person:\n  present: true\n  box:\n    center: [" << box.center.x() << ", "
         << box.center.y() << ", " << box.center.z() << "]\n    size: [" << box.size.x() + 0.04
         << ", " << box.size.y() + 0.04 << ", " << box.size.z() + 0.04 << "]\n    yaw: " << box.yaw
         << "\n";
}

}  // namespace fallen::lying_scene
