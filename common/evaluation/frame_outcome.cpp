// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/frame_outcome.hpp"

#include <algorithm>

namespace fallen {

int CountCellsInBox(const NdtMap& map, const OrientedBox& box) {
  return static_cast<int>(
      std::count_if(map.cells.begin(), map.cells.end(),
                    [&](const NdtCell& cell) { return box.Contains(cell.mean.cast<double>()); }));
}

FrameOutcome JudgeFrame(const Decision& decision, const std::optional<OrientedBox>& person_box,
                        int cells_in_box) {
  FrameOutcome outcome;
  outcome.is_positive = person_box && cells_in_box >= kMinCellsInBox;
  for (const PersonHypothesis& hypothesis : decision.hypotheses) {
    if (!person_box || !person_box->Contains(hypothesis.centroid)) {
      outcome.false_scores.push_back(hypothesis.probability);
      continue;
    }
    if (!outcome.is_positive) continue;
    if (!outcome.hit_score) {
      outcome.hit_score = hypothesis.probability;
      continue;
    }
    outcome.false_scores.push_back(std::min(*outcome.hit_score, hypothesis.probability));
    outcome.hit_score = std::max(*outcome.hit_score, hypothesis.probability);
  }
  return outcome;
}

}  // namespace fallen
