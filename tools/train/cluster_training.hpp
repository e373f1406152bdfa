// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "fallen/evaluation/detection_error_tradeoff.hpp"
#include "tools/train/cluster_samples.hpp"
#include "tools/train/training_config.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// Codebook, Gaussian and calibration (the paper, Sec. III-E and III-F).
struct ClusterTraining {
  ClusterModel model;
  double shrinkage = 0;
  std::int64_t person_clusters = 0;  ///< that the Gaussian was fitted to
};

/// Learns codebook and Gaussian from the clusters that `cells` makes of the training frames; with
/// PositiveCells::kIsolated, of nothing but the persons in them.
/// @throws std::runtime_error if the segmentation finds too few persons to fit a Gaussian to.
ClusterTraining TrainClusterModel(std::span<const ObservedFrame* const> frames,
                                  const IronDescriptors::Matrix& person_descriptors,
                                  const CellModel& cells, const TrainingConfig& config, int jobs,
                                  const TrainingProgress& progress);

/// Trains the trees of a ClusterModel; both classes weigh the same.
/// @throws std::runtime_error if `samples` hold one class only.
BoostedTrees TrainClusterTrees(const ClusterSamples& samples, const BoostingConfig& config,
                               int jobs, const TrainingProgress& progress);

/// Trains the network of a ClusterModel; both classes weigh the same.
/// @throws std::runtime_error if `samples` hold one class only.
FeatureNetwork TrainClusterNetwork(const ClusterSamples& samples,
                                   const NetworkTrainingConfig& config,
                                   const TrainingProgress& progress);

/// What came of the calibration.
struct CalibrationResult {
  Calibration calibration;
  DetectionErrorTradeoff tradeoff;  ///< on the validation frames
  std::int64_t person_clusters = 0;
  std::int64_t other_clusters = 0;
};

/// Fits p(fallen | evidence) to the clusters of the validation frames, and measures the operating
/// points.
/// @throws std::runtime_error if the segmentation finds no person there, or nothing but persons.
CalibrationResult CalibrateOnFrames(std::span<const ObservedFrame* const> frames,
                                    const CellModel& cells, const ClusterModel& model,
                                    const TrainingConfig& config, int jobs,
                                    const TrainingProgress& progress);

}  // namespace fallen
