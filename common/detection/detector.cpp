// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/detector.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "fallen/detection/stopwatch.hpp"

namespace fallen {
namespace {

const Model& Validated(const Model& model) {
  model.Validate();
  return model;
}

void CheckTheyFit(const Model& model, const DetectorConfig& config,
                  const BackgroundSubtractor& background) {
  if (config.ndt.cell_size_m != model.cells.cell_size_m)
    throw std::invalid_argument("ndt.cell_size_m is " + std::to_string(config.ndt.cell_size_m) +
                                ", but the model was trained with " +
                                std::to_string(model.cells.cell_size_m));
  // An environment map of another cell size must be refused now, not at the first frame with a
  // pose.
  NdtMap no_cells;
  no_cells.cell_size_m = config.ndt.cell_size_m;
  no_cells.frame = MapFrame::kWorld;
  background.Subtract(std::move(no_cells));
}

}  // namespace

void DetectorConfig::Validate() const {
  ground.Validate();
  ndt.Validate();
  background.Validate();
  segmentation.Validate();
  classification.Validate();
}

Detector::Detector(Model model, const DetectorConfig& config, BackgroundSubtractor background)
    : model_(std::move(model)),
      config_(config),
      background_(std::move(background)),
      mapper_(config.ndt),
      segmenter_(Validated(model_).cells, config.segmentation),
      classifier_(model_.clusters) {
  config_.Validate();
  CheckTheyFit(model_, config_, background_);
}

FrameResult Detector::Detect(const Frame& frame) {
  FrameResult result;
  Detect(frame, result);
  return result;
}

void Detector::Detect(const Frame& frame, FrameResult& result) {
  StageTimes& times = result.milliseconds;
  Stopwatch total;

  UpdateMap(mapper_, frame, config_.ground, result.foreground.map, &times);

  Stopwatch stage;
  background_.Subtract(result.foreground);
  times.background = stage.LapMilliseconds();

  SegmentationTimes segmentation;
  segmenter_.Segment(result.foreground, result.segmented, &segmentation);
  times.iron = segmentation.iron;
  times.cells = segmentation.cells;

  stage.LapMilliseconds();
  classifier_.Classify(result.segmented, config_.classification, result.decision);
  times.clusters = segmentation.clusters + stage.LapMilliseconds();

  times.total = total.LapMilliseconds();
}

}  // namespace fallen
