// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "fallen/baseline/baseline_model.hpp"
#include "tools/train/baseline_observation.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// Which frames the baseline learns from and is measured on.
struct BaselineSamplingConfig {
  int frame_stride = 13;            ///< of training recordings, every so many frames, >= 1
  int validation_frame_stride = 2;  ///< of validation recordings, >= 1
  std::int64_t seed = 1;            ///< of the split, where no validation recordings are named

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("frame_stride", frame_stride);
    visit("validation_frame_stride", validation_frame_stride);
    visit("seed", seed);
  }
};

/// All settings of a training of the baseline, the sections of models/baseline.yaml.
struct BaselineTrainingConfig {
  BaselineSamplingConfig sampling;
  BaselineConfig baseline;
  BoostingConfig boosting{
      .rounds = 400, .max_depth = 6, .min_leaf_weight = 1e-3, .learning_rate = 0.1};

  /// @throws std::invalid_argument for the first setting that is out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("sampling", sampling);
    visit("baseline", baseline);
    visit("boosting", boosting);
  }
};

/// @throws std::runtime_error naming file, line, got and expected. No file: the defaults.
BaselineTrainingConfig LoadBaselineTrainingConfig(const std::optional<std::filesystem::path>& path);

/// A trained baseline and the record of its training.
struct TrainedBaseline {
  BaselineModel model;
  nlohmann::json report;  ///< data, settings and figures on the validation recordings
};

/// Trains the trees on the clusters of the training recordings, a person's if the centroid lies in
/// the labelled box, and the calibration on those of the validation recordings.
/// @param validation  Cells counted.
/// @throws std::runtime_error if the recordings hold too little to learn from.
/// Deterministic; `jobs` changes nothing but the time.
TrainedBaseline TrainBaseline(const std::vector<BaselineRecording>& training,
                              const std::vector<BaselineRecording>& validation,
                              const BaselineTrainingConfig& config, int jobs,
                              const TrainingProgress& progress);

}  // namespace fallen
