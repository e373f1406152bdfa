// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "fallen/geometry/camera_intrinsics.hpp"
#include "fallen/messages/conversions.hpp"
#include "tools/import/label_file.hpp"

/// Recordings as directories in the style of the TUM RGB-D benchmark.
///
/// [Sturm12] Sturm, Engelhard, Endres, Burgard, Cremers: A benchmark for the evaluation of RGB-D
/// SLAM
///           systems. IROS 2012.
namespace fallen {

/// One row of `depth.txt`.
struct TumFrame {
  std::int64_t utime = 0;                           ///< time of measurement [us]
  std::filesystem::path image;                      ///< 16-bit PNG
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< from `groundtruth.txt`, where one is near
};

/// All of a directory but for the images.
struct TumDirectory {
  CameraIntrinsics intrinsics;
  double depth_unit_m = 0.001;
  std::vector<TumFrame> frames;     ///< by time; at least one
  std::optional<LabelFile> labels;  ///< nothing without `labels.yaml`

  /// What `labels.yaml` says of frame `index`, if anything.
  std::optional<GroundTruth> TruthOf(std::size_t index) const;
};

/// Reads `depth.txt` (`timestamp filename`), `camera.yaml` (width height fx fy cx cy depth_scale)
/// and, where they are, `groundtruth.txt` (`timestamp tx ty tz qx qy qz qw`: camera in a world with
/// z up and the floor at 0) and `labels.yaml` (LabelFile).
///
/// Poses are interpolated at the images' times, as those of a robot are (PoseBuffer).
/// @throws InputError naming file, line, got and expected.
TumDirectory ReadTumDirectory(const std::filesystem::path& directory);

/// The messages that frame `index` of a directory becomes.
struct TumMessages {
  std::optional<StampedPose> pose;  ///< of the robot; only with a camera pose
  std::optional<GroundTruth> truth;
  StampedDepthImage depth;  ///< with the mounting, where there is a pose
};

/// Loads the image of frame `index` and splits the camera's pose. @throws InputError.
TumMessages LoadTumFrame(const TumDirectory& directory, std::size_t index,
                         const std::string& sensor_name);

}  // namespace fallen
