// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/hypothesis_selection.hpp"

#include <algorithm>
#include <utility>

namespace fallen {

std::vector<PersonHypothesis> BestOfEachPlace(std::vector<PersonHypothesis> hypotheses,
                                              double min_separation_m) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const PersonHypothesis& a, const PersonHypothesis& b) {
                     return a.probability > b.probability;
                   });
  std::vector<PersonHypothesis> kept;
  for (PersonHypothesis& candidate : hypotheses) {
    const bool is_alone = std::none_of(kept.begin(), kept.end(), [&](const auto& better) {
      return (better.centroid - candidate.centroid).template head<2>().norm() < min_separation_m;
    });
    if (is_alone) kept.push_back(std::move(candidate));
  }
  return kept;
}

}  // namespace fallen
