// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/classification/cluster_classifier.hpp"
#include "fallen/detection/frame.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/detection/model.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_mapper.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/segmentation/cell_segmenter.hpp"

namespace fallen {

struct DetectorConfig {
  GroundConfig ground;
  NdtConfig ndt;
  BackgroundConfig background;
  SegmentationConfig segmentation;
  ClassificationConfig classification;

  /// @throws std::invalid_argument for the first setting that is out of range.
  void Validate() const;
};

/// Everything that is known about a frame after its decision.
struct FrameResult {
  ForegroundMap foreground;
  SegmentedMap segmented;
  Decision decision;
  StageTimes milliseconds;
};

/// The stages composed: a depth image and a pose go in, fallen persons come out.
///
/// Every frame gets a decision, one without a floor in view too. Guards the accumulated map, so the
/// order of the calls matters. Not thread-safe. Deterministic but for the times.
class Detector {
 public:
  /// @param model       Settings of the training are in it; `config.segmentation` is what is used.
  /// @param background  Keeps its own settings: `config.background` is checked only.
  /// @throws std::invalid_argument if model or config is out of range or they do not fit together.
  Detector(Model model, const DetectorConfig& config, BackgroundSubtractor background);

  /// @throws std::invalid_argument if the image or a transform is malformed; the map is unchanged
  /// then.
  FrameResult Detect(const Frame& frame);
  /// Likewise, into memory that is there: given the same `result` frame after frame, nothing is
  /// allocated once the memory is large enough, but for the search of a floor in the image.
  void Detect(const Frame& frame, FrameResult& result);

 private:
  Model model_;
  DetectorConfig config_;
  BackgroundSubtractor background_;
  NdtMapper mapper_;
  CellSegmenter segmenter_;
  ClusterClassifier classifier_;
};

}  // namespace fallen
