// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/tum_directory.hpp"

#include <array>
#include <cmath>
#include <string>

#include "fallen/geometry/pose_buffer.hpp"
#include "tools/import/camera_pose_split.hpp"
#include "tools/import/depth_png.hpp"
#include "tools/import/input_error.hpp"
#include "tools/import/text_table.hpp"
#include "tools/import/yaml_file.hpp"

namespace fallen {
namespace {

/// Coarser than this, depth cannot be meant: units per metre written for metres per unit.
constexpr double kMaxDepthUnitM = 0.1;
/// Quaternions are written with four decimals and more: their length may be off by so much.
constexpr double kQuaternionTolerance = 0.01;

void ReadCamera(const std::filesystem::path& path, TumDirectory& directory) {
  const YamlFile file(path);
  const YAML::Node& root = file.root();
  CameraIntrinsics& camera = directory.intrinsics;
  camera.width = file.WholeNumber(root, "width");
  camera.height = file.WholeNumber(root, "height");
  camera.fx = file.PositiveNumber(root, "fx");
  camera.fy = file.PositiveNumber(root, "fy");
  camera.cx = file.Number(root, "cx");
  camera.cy = file.Number(root, "cy");
  directory.depth_unit_m = file.PositiveNumber(root, "depth_scale");
  if (directory.depth_unit_m > kMaxDepthUnitM)
    file.Fail(root["depth_scale"], "depth_scale " + root["depth_scale"].Scalar(),
              "metres per unit, at most 0.1");
  try {
    camera.Validate();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

void ReadFrames(const std::filesystem::path& path, TumDirectory& directory) {
  for (const TableRow& row : ReadTimedTable(path, "timestamp filename", 1))
    directory.frames.push_back({row.utime, path.parent_path() / row.fields[0], std::nullopt});
  if (directory.frames.empty())
    throw InputError(path, 0, "no image", "rows of \"timestamp filename\"");
}

StampedPose ParsePose(const std::filesystem::path& path, const TableRow& row) {
  constexpr std::array<const char*, 7> kNames = {"tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  std::array<double, kNames.size()> value{};
  for (std::size_t i = 0; i < kNames.size(); ++i) value[i] = NumberField(path, row, i, kNames[i]);
  StampedPose pose;
  pose.utime = row.utime;
  pose.translation = {value[0], value[1], value[2]};
  pose.rotation = Eigen::Quaterniond(value[6], value[3], value[4], value[5]);
  if (std::abs(pose.rotation.norm() - 1) > kQuaternionTolerance)
    throw InputError(path, row.line,
                     "a quaternion of length " + std::to_string(pose.rotation.norm()), "length 1");
  pose.rotation.normalize();
  return pose;
}

void ReadPoses(const std::filesystem::path& path, TumDirectory& directory) {
  std::vector<StampedPose> poses;
  for (const TableRow& row : ReadTimedTable(path, "timestamp tx ty tz qx qy qz qw", 7))
    poses.push_back(ParsePose(path, row));

  PoseBuffer buffer;
  std::size_t next = 0;
  for (TumFrame& frame : directory.frames) {
    // The buffer holds the recent past: it is given poses until one lies behind the frame.
    while (next < poses.size() && (next == 0 || poses[next - 1].utime < frame.utime)) {
      buffer.Add(poses[next].utime, poses[next].translation, poses[next].rotation);
      ++next;
    }
    frame.T_world_camera = buffer.At(frame.utime);
  }
}

}  // namespace

TumDirectory ReadTumDirectory(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path))
    throw InputError(path, 0, "no directory", "one with depth.txt and camera.yaml");
  TumDirectory directory;
  ReadCamera(path / "camera.yaml", directory);
  ReadFrames(path / "depth.txt", directory);
  if (std::filesystem::exists(path / "groundtruth.txt"))
    ReadPoses(path / "groundtruth.txt", directory);
  if (std::filesystem::exists(path / "labels.yaml"))
    directory.labels = ReadLabelFile(path / "labels.yaml");
  return directory;
}

std::optional<GroundTruth> TumDirectory::TruthOf(std::size_t index) const {
  if (!labels) return std::nullopt;
  const double seconds = static_cast<double>(frames.at(index).utime - frames.front().utime) * 1e-6;
  return labels->At(static_cast<std::int64_t>(index), seconds);
}

TumMessages LoadTumFrame(const TumDirectory& directory, std::size_t index,
                         const std::string& sensor_name) {
  const TumFrame& frame = directory.frames.at(index);
  TumMessages messages;
  messages.truth = directory.TruthOf(index);
  messages.depth.header = {frame.utime, static_cast<std::int64_t>(index), sensor_name};
  messages.depth.image.intrinsics = directory.intrinsics;
  messages.depth.image.depth_unit_m = directory.depth_unit_m;
  messages.depth.image.depth =
      ReadDepthPng(frame.image, directory.intrinsics.width, directory.intrinsics.height);
  if (!frame.T_world_camera) return messages;

  const RobotAndMounting split = SplitCameraPose(*frame.T_world_camera);
  messages.depth.T_robot_camera = split.T_robot_camera;
  messages.pose = StampedPose{frame.utime, split.T_world_robot.translation(),
                              Eigen::Quaterniond(split.T_world_robot.linear())};
  return messages;
}

}  // namespace fallen
