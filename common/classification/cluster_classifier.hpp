// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fallen/classification/cluster_candidates.hpp"

namespace fallen {

/// ClassifyClusters for frame after frame: with the model prepared once, and in the same memory.
/// Not thread-safe.
class ClusterClassifier {
 public:
  /// @param model  Valid: see ClusterModel::Validate.
  explicit ClusterClassifier(ClusterModel model);

  /// Into memory that is there. @throws std::invalid_argument as ClassifyClusters.
  void Classify(const SegmentedMap& segmented, const ClassificationConfig& config,
                Decision& decision);

 private:
  ClusterModel model_;
  CandidateFinder finder_;
  EvidenceScorer scorer_;
  std::vector<PersonHypothesis> of_one_cluster_;
};

}  // namespace fallen
