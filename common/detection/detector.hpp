// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// All that training produces.
struct Model {
  CellModel cells;
  ClusterModel clusters;
  SegmentationConfig segmentation;  ///< the settings under which the clusters were trained
  std::string description;          ///< data, seed and date of the training, for people

  void Validate() const;
};

struct DetectorConfig {
  GroundConfig ground;
  NdtConfig ndt;
  BackgroundConfig background;
  SegmentationConfig segmentation;
  ClassificationConfig classification;
};

/// One picture as it enters the chain.
struct Frame {
  std::int64_t utime = 0;  ///< time of measurement [us]
  DepthImage image;
  std::optional<Eigen::Isometry3d> T_robot_camera;  ///< mounting, z of the robot up from the floor
  std::optional<Eigen::Isometry3d> T_world_robot;   ///< pose at `utime`
};

/// Time spent in each stage [ms].
struct StageTimes {
  double ground = 0, ndt = 0, background = 0, iron = 0, cells = 0, clusters = 0, total = 0;
};

/// Everything that is known about a frame after its decision.
struct FrameResult {
  ForegroundMap foreground;
  SegmentedMap segmented;
  Decision decision;
  StageTimes milliseconds;
};

/// First stage, shared by the mapping service and the detector: ground, pose, map.
NdtMap UpdateMap(NdtMapper& mapper, const Frame& frame, const GroundConfig& config,
                 StageTimes* milliseconds = nullptr);

/// The stages composed: a depth image and a pose go in, fallen persons come out.
class Detector {
 public:
  /// @throws std::invalid_argument if model or config is out of range or they do not fit together.
  Detector(Model model, const DetectorConfig& config, BackgroundSubtractor background);

  FrameResult Detect(const Frame& frame);

 private:
  Model model_;
  DetectorConfig config_;
  BackgroundSubtractor background_;
  NdtMapper mapper_;
};

}  // namespace fallen
