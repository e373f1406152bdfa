// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace fallen::testing_support {

/// One service of the chain, seen from outside, for camera CAMERA.
struct Stage {
  std::string service;  ///< as in "fallen-<service>"
  std::string inputs;   ///< regular expression of the channels that it reads
  std::string output;
  bool needs_model = false;
};

/// The services behind the camera, in order.
inline const std::array<Stage, 4> kStages{
    {{"ndt-mapping", "DEPTH_CAMERA|ROBOT_POSE", "NDT_MAP_CAMERA"},
     {"background-subtraction", "NDT_MAP_CAMERA", "FOREGROUND_CAMERA"},
     {"cell-segmentation", "FOREGROUND_CAMERA", "CLUSTERS_CAMERA", true},
     {"cluster-classification", "CLUSTERS_CAMERA", "FALLEN_PERSONS_CAMERA", true}}};

}  // namespace fallen::testing_support
