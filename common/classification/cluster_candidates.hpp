// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fallen/classification/cluster_classification.hpp"

namespace fallen {

/// A cluster, or a part of one, with all that it is judged by.
struct ClusterCandidate {
  CellCluster cluster;
  std::int32_t whole = 0;                              ///< index of the cluster in the map
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< mean of the cells' means, map frame [m]
  OrientedBox box;                                     ///< FitUprightBox of `cluster`
  Eigen::VectorXd code;                                ///< EncodeCluster of `cluster`
  double mahalanobis_distance = 0;
  Eigen::RowVectorXf features;  ///< ComputeClusterFeatures, or empty
};

/// Every cluster as it is, without features: what the paper judges.
/// @param model  Codebook and Gaussian are used. Deterministic. Thread-safe.
std::vector<ClusterCandidate> WholeClusters(const SegmentedMap& segmented,
                                            const ClusterModel& model);

/// Every cluster, each followed by its parts (FindClusterParts), with features. Without a floor,
/// from which features are measured, as WholeClusters.
/// @param model  Codebook and Gaussian are used. Deterministic. Thread-safe.
std::vector<ClusterCandidate> ClustersAndParts(const SegmentedMap& segmented,
                                               const ClusterModel& model);

/// What `model` judges: ClustersAndParts by trees, else WholeClusters.
std::vector<ClusterCandidate> FindCandidates(const SegmentedMap& segmented,
                                             const ClusterModel& model);

/// How much each candidate looks like a fallen person, as ClusterModel::calibration takes it: the
/// score of the model's trees, [-1, 1], or MahalanobisEvidence from a model without. A model with
/// trees gives -1 to candidates without features: without a floor nothing can be said to lie on it.
std::vector<double> ClusterEvidence(std::span<const ClusterCandidate> candidates,
                                    const ClusterModel& model);

}  // namespace fallen
