// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/hypothesis_selection.hpp"

#include <algorithm>

namespace fallen {

void KeepBestOfEachPlace(std::vector<PersonHypothesis>& hypotheses, double min_separation_m) {
  // Into the sorted ones before it, one after the other: few they are, and std::stable_sort would
  // allocate.
  for (auto next = hypotheses.begin(); next != hypotheses.end(); ++next)
    std::rotate(std::upper_bound(hypotheses.begin(), next, *next,
                                 [](const PersonHypothesis& a, const PersonHypothesis& b) {
                                   return a.probability > b.probability;
                                 }),
                next, next + 1);
  auto kept = hypotheses.begin();
  for (const PersonHypothesis& candidate : hypotheses) {
    const bool is_alone = std::none_of(hypotheses.begin(), kept, [&](const auto& better) {
      return (better.centroid - candidate.centroid).template head<2>().norm() < min_separation_m;
    });
    if (is_alone) *kept++ = candidate;
  }
  hypotheses.erase(kept, hypotheses.end());
}

}  // namespace fallen
