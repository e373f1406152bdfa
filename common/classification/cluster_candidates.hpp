// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/classification/cluster_parts.hpp"
#include "fallen/segmentation/tree_scorer.hpp"

namespace fallen {

/// A cluster, or a part of one, with all that it is judged by.
struct ClusterCandidate {
  CellCluster cluster;
  std::int32_t whole = 0;  ///< index of the cluster in the map
  /// Mean of the cells' means [m], map frame; from ClustersAndParts weighted by score, so that it
  /// is the person's where somebody is joined with a thing.
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  OrientedBox box;       ///< FitUprightBox of `cluster`
  Eigen::VectorXd code;  ///< EncodeCluster of `cluster`
  double mahalanobis_distance = 0;
  Eigen::RowVectorXf features;  ///< ComputeClusterFeatures, or empty
};

/// Finds what there is to judge in frame after frame, in the same memory. Deterministic.
///
/// What it found holds until the next call. Of the models, codebook and Gaussian are used.
class CandidateFinder {
 public:
  /// Every cluster as it is, without features: what the paper judges.
  std::span<const ClusterCandidate> WholeClusters(const SegmentedMap& segmented,
                                                  const ClusterModel& model);

  /// Every cluster, each followed by its parts (ClusterPartFinder), with features. Without a floor,
  /// from which features are measured, as WholeClusters.
  std::span<const ClusterCandidate> ClustersAndParts(const SegmentedMap& segmented,
                                                     const ClusterModel& model);

  /// What `model` judges: ClustersAndParts by trees, else WholeClusters.
  std::span<const ClusterCandidate> Find(const SegmentedMap& segmented, const ClusterModel& model);

 private:
  ClusterCandidate& Add(const SegmentedMap& segmented, const CellCluster& cluster,
                        std::span<const std::int32_t> members, std::size_t whole,
                        const ClusterModel& model);
  ClusterCandidate& AddWhole(const SegmentedMap& segmented, std::size_t whole,
                             const ClusterModel& model);

  std::vector<ClusterCandidate> candidates_;  // the first `count_`, then those of earlier frames
  std::size_t count_ = 0;
  std::vector<std::int32_t> all_members_;
  ClusterPartFinder parts_;
};

/// Tells how much candidates look like fallen persons, frame after frame in the same memory.
class EvidenceScorer {
 public:
  /// @param model  Valid: see ClusterModel::Validate.
  explicit EvidenceScorer(const ClusterModel& model)
      : scorer_(model.trees),
        has_trees_(!model.trees.roots.empty()),
        network_(model.network),
        network_share_(model.network.empty() ? 0 : model.network_share) {}

  /// Evidence as ClusterModel::calibration takes it, one value a candidate, until the next call:
  /// the score of the model's trees, [-1, 1], or its mean with the network's by their shares, or
  /// MahalanobisEvidence from a model without trees. A model with trees gives -1 to candidates
  /// without features: without a floor nothing can be said to lie on it.
  std::span<const double> Score(std::span<const ClusterCandidate> candidates);

 private:
  TreeScorer scorer_;
  bool has_trees_;
  NetworkScorer network_;
  double network_share_;
  FeatureMatrix features_;
  std::vector<float> scores_, network_scores_;
  std::vector<double> evidence_;
};

}  // namespace fallen
