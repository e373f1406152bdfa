// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"
#include "tools/train/observation.hpp"
#include "tools/train/training_config.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// What the segmentation would do with an observed frame: everything is foreground.
SegmentedMap SegmentObserved(const ObservedFrame& frame, const CellModel& cells,
                             const TrainingConfig& config);

/// Clusters to learn from, one a row.
struct ClusterSamples {
  FeatureMatrix features;
  std::vector<std::int8_t> labels;  ///< +1: a fallen person, -1: anything else
  std::vector<float> weights;       ///< > 0, against others of the same label
};

/// All rows of the parts, in order; features of equally many columns.
ClusterSamples JoinSamples(std::span<const ClusterSamples> parts);

/// Features of all clusters that `cells` makes of the frames, and of their parts.
///
/// One is a fallen person's if its centroid lies in the labelled box: what the evaluation
/// counts as found (the paper, Sec. IV-B). A frame's person weighs as much as that of any other
/// frame, into however many parts it falls: it is found if one of them is, and somebody who is
/// hardly seen falls into few. Frames without a floor give none.
/// @param model  Codebook and Gaussian.
ClusterSamples CollectClusterSamples(std::span<const ObservedFrame* const> frames,
                                     const CellModel& cells, const ClusterModel& model,
                                     const TrainingConfig& config, int jobs,
                                     const TrainingProgress& progress);

}  // namespace fallen
