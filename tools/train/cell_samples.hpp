// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "tools/train/observation.hpp"
#include "tools/train/training_config.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// Cells with their features and what they are.
struct CellSamples {
  FeatureMatrix features;
  std::vector<std::int8_t> labels;             ///< +1 person, -1 other
  std::vector<float> weights;                  ///< both classes weigh the same in total
  IronDescriptors::Matrix person_descriptors;  ///< for the codebook
};

/// Draws cells from the frames: the same share of each frame's, so that all frames count alike.
/// Cells above `config.segmentation.max_height_m` are left out: they are never judged.
/// @throws std::runtime_error if one class is missing.
CellSamples CollectCellSamples(std::span<const ObservedFrame* const> frames,
                               const TrainingConfig& config, int jobs,
                               const TrainingProgress& progress);

}  // namespace fallen
