// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_candidates.hpp"

#include <algorithm>
#include <numeric>

#include "fallen/classification/calibration.hpp"
#include "fallen/classification/cluster_features.hpp"
#include "fallen/classification/soft_threshold_encoding.hpp"

namespace fallen {
namespace {

// Least score that trees can give.
constexpr double kNoFloor = -1;

// Of a person joined with a thing most of the score is the person's.
Eigen::Vector3d ScoreWeightedMean(const SegmentedMap& segmented, const CellCluster& cluster) {
  constexpr double kLeastWeight = 1e-3;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0;
  for (const std::int32_t index : cluster.cells) {
    const ScoredCell& scored = segmented.cells[index];
    const double weight = std::max<double>(scored.score, kLeastWeight);
    sum += weight * scored.mean.cast<double>();
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

ClusterCandidate& CandidateFinder::Add(const SegmentedMap& segmented, const CellCluster& cluster,
                                       std::span<const std::int32_t> members, std::size_t whole,
                                       const ClusterModel& model) {
  if (count_ == candidates_.size()) candidates_.emplace_back();
  ClusterCandidate& candidate = candidates_[count_++];
  TakeMembers(cluster, members, candidate.cluster);
  candidate.whole = static_cast<std::int32_t>(whole);
  candidate.centroid.setZero();
  for (const std::int32_t index : candidate.cluster.cells)
    candidate.centroid += segmented.cells[index].mean.cast<double>();
  candidate.centroid /= static_cast<double>(members.size());
  candidate.box = FitUprightBox(segmented, candidate.cluster);
  EncodeCluster(candidate.cluster.MemberDescriptors(), model.codebook, model.alpha, candidate.code);
  candidate.mahalanobis_distance = model.gaussian.Distance(candidate.code);
  return candidate;
}

ClusterCandidate& CandidateFinder::AddWhole(const SegmentedMap& segmented, std::size_t whole,
                                            const ClusterModel& model) {
  const CellCluster& cluster = segmented.clusters[whole];
  all_members_.resize(cluster.cells.size());
  std::iota(all_members_.begin(), all_members_.end(), 0);
  return Add(segmented, cluster, all_members_, whole, model);
}

std::span<const ClusterCandidate> CandidateFinder::WholeClusters(const SegmentedMap& segmented,
                                                                 const ClusterModel& model) {
  count_ = 0;
  for (std::size_t c = 0; c < segmented.clusters.size(); ++c)
    AddWhole(segmented, c, model).features.resize(0);
  return std::span(candidates_).first(count_);
}

std::span<const ClusterCandidate> CandidateFinder::ClustersAndParts(const SegmentedMap& segmented,
                                                                    const ClusterModel& model) {
  if (!segmented.ground.ok()) return WholeClusters(segmented, model);
  count_ = 0;
  const ClusterScene scene(segmented);
  for (std::size_t c = 0; c < segmented.clusters.size(); ++c) {
    const CellCluster& cluster = segmented.clusters[c];
    const std::size_t first = count_;
    const OrientedBox box = AddWhole(segmented, c, model).box;
    parts_.Find(segmented, cluster, box);
    for (std::size_t i = 0; i < parts_.count(); ++i)
      Add(segmented, cluster, parts_.part(i), c, model);
    for (std::size_t i = first; i < count_; ++i) {
      ClusterCandidate& candidate = candidates_[i];
      candidate.centroid = ScoreWeightedMean(segmented, candidate.cluster);
      ComputeClusterFeatures(scene, candidate.cluster, candidate.box, {cluster, box},
                             candidate.code, candidate.mahalanobis_distance, candidate.features);
    }
  }
  return std::span(candidates_).first(count_);
}

std::span<const ClusterCandidate> CandidateFinder::Find(const SegmentedMap& segmented,
                                                        const ClusterModel& model) {
  return model.trees.roots.empty() ? WholeClusters(segmented, model)
                                   : ClustersAndParts(segmented, model);
}

std::span<const double> EvidenceScorer::Score(std::span<const ClusterCandidate> candidates) {
  evidence_.assign(candidates.size(), kNoFloor);
  if (!has_trees_) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      evidence_[i] = MahalanobisEvidence(candidates[i].mahalanobis_distance);
    return evidence_;
  }
  if (candidates.empty() || candidates[0].features.size() == 0) return evidence_;
  const auto rows = static_cast<Eigen::Index>(candidates.size());
  GrowRows(features_, rows, candidates[0].features.size());
  for (Eigen::Index i = 0; i < rows; ++i)
    features_.row(i) = candidates[static_cast<std::size_t>(i)].features;
  scorer_.Score(features_.topRows(rows), scores_);
  evidence_.assign(scores_.begin(), scores_.end());
  if (network_share_ > 0) {
    network_.Score(features_.topRows(rows), network_scores_);
    for (std::size_t i = 0; i < evidence_.size(); ++i)
      evidence_[i] += network_share_ * (network_scores_[i] - evidence_[i]);
  }
  return evidence_;
}

}  // namespace fallen
