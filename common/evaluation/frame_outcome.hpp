// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/geometry/oriented_box.hpp"
#include "fallen/ndt/ndt_map.hpp"

/// The paper's protocol (Sec. IV-B): which hypotheses of a frame are hits, which are false.
namespace fallen {

/// A person counts as present only if so many cells of the local map lie in the labelled box
/// (the paper, Sec. IV-B).
inline constexpr int kMinCellsInBox = 100;

/// What a frame contributes to a detection error trade-off curve.
struct FrameOutcome {
  /// A fallen person is there, and enough of it is seen.
  bool is_positive = false;
  /// Score of the best hypothesis in the box, of a positive frame; nothing if there is none.
  std::optional<double> hit_score;
  /// Scores of all hypotheses that count as false if they are accepted.
  std::vector<double> false_scores;
};

/// Number of cells whose mean lies in `box` (map frame).
int CountCellsInBox(const NdtMap& map, const OrientedBox& box);

/// Judges the hypotheses of one frame; the score is the probability.
///
/// A hypothesis hits if its centroid lies in the box. In a positive frame the best hit is the true
/// positive, further hits count as false, as in the paper. The paper leaves open what a hypothesis
/// in the box of a frame with too few cells is: here it counts neither way.
/// @param person_box      Box of the fallen person in the decision's frame, or nothing.
/// @param cells_in_box    CountCellsInBox of the same frame.
FrameOutcome JudgeFrame(const Decision& decision, const std::optional<OrientedBox>& person_box,
                        int cells_in_box);

}  // namespace fallen
