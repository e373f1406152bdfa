// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_candidates.hpp"

#include <utility>

#include "fallen/classification/cluster_features.hpp"
#include "fallen/classification/cluster_parts.hpp"
#include "fallen/classification/soft_threshold_encoding.hpp"

namespace fallen {
namespace {

// Least score that trees can give.
constexpr double kNoFloor = -1;

ClusterCandidate MakeCandidate(const SegmentedMap& segmented, CellCluster cluster,
                               std::size_t whole, const ClusterModel& model) {
  ClusterCandidate candidate;
  candidate.whole = static_cast<std::int32_t>(whole);
  for (const std::int32_t index : cluster.cells)
    candidate.centroid += segmented.cells[index].cell.mean.cast<double>();
  candidate.centroid /= static_cast<double>(cluster.cells.size());
  candidate.box = FitUprightBox(segmented, cluster);
  candidate.code = EncodeCluster(cluster.descriptors, model.codebook, model.alpha);
  candidate.mahalanobis_distance = model.gaussian.Distance(candidate.code);
  candidate.cluster = std::move(cluster);
  return candidate;
}

}  // namespace

std::vector<ClusterCandidate> WholeClusters(const SegmentedMap& segmented,
                                            const ClusterModel& model) {
  std::vector<ClusterCandidate> candidates;
  for (std::size_t c = 0; c < segmented.clusters.size(); ++c)
    candidates.push_back(MakeCandidate(segmented, segmented.clusters[c], c, model));
  return candidates;
}

std::vector<ClusterCandidate> ClustersAndParts(const SegmentedMap& segmented,
                                               const ClusterModel& model) {
  if (!segmented.ground.ok()) return WholeClusters(segmented, model);
  const ClusterScene scene(segmented);
  std::vector<ClusterCandidate> candidates;
  for (std::size_t c = 0; c < segmented.clusters.size(); ++c) {
    const CellCluster& cluster = segmented.clusters[c];
    const std::size_t first = candidates.size();
    candidates.push_back(MakeCandidate(segmented, cluster, c, model));
    for (CellCluster& part : FindClusterParts(segmented, cluster, candidates[first].box))
      candidates.push_back(MakeCandidate(segmented, std::move(part), c, model));
    const WholeCluster whole{cluster, candidates[first].box};
    for (std::size_t i = first; i < candidates.size(); ++i) {
      ClusterCandidate& candidate = candidates[i];
      candidate.features = ComputeClusterFeatures(scene, candidate.cluster, candidate.box, whole,
                                                  candidate.code, candidate.mahalanobis_distance);
    }
  }
  return candidates;
}

std::vector<ClusterCandidate> FindCandidates(const SegmentedMap& segmented,
                                             const ClusterModel& model) {
  return model.trees.roots.empty() ? WholeClusters(segmented, model)
                                   : ClustersAndParts(segmented, model);
}

std::vector<double> ClusterEvidence(std::span<const ClusterCandidate> candidates,
                                    const ClusterModel& model) {
  std::vector<double> evidence(candidates.size(), kNoFloor);
  if (model.trees.roots.empty()) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      evidence[i] = MahalanobisEvidence(candidates[i].mahalanobis_distance);
    return evidence;
  }
  if (candidates.empty() || candidates[0].features.size() == 0) return evidence;
  FeatureMatrix features(static_cast<Eigen::Index>(candidates.size()),
                         candidates[0].features.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    features.row(static_cast<Eigen::Index>(i)) = candidates[i].features;
  const std::vector<float> scores = PredictScores(model.trees, features);
  return {scores.begin(), scores.end()};
}

}  // namespace fallen
