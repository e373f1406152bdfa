// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/cluster_samples.hpp"

#include <algorithm>
#include <atomic>

#include "fallen/classification/cluster_candidates.hpp"
#include "fallen/classification/cluster_features.hpp"
#include "fallen/segmentation/parallel_for.hpp"

namespace fallen {
namespace {

ClusterSamples SampleFrame(const ObservedFrame& frame, const CellModel& cells,
                           const ClusterModel& model, const TrainingConfig& config) {
  ClusterSamples samples;
  const SegmentedMap segmented = SegmentObserved(frame, cells, config);
  samples.features.resize(0, ClusterFeatureCount(model.iron, model.codebook.rows()));
  if (!segmented.ground.ok()) return samples;
  CandidateFinder finder;
  const std::span<const ClusterCandidate> candidates = finder.ClustersAndParts(segmented, model);
  samples.features.resize(static_cast<Eigen::Index>(candidates.size()), Eigen::NoChange);
  for (const ClusterCandidate& candidate : candidates) {
    samples.features.row(static_cast<Eigen::Index>(samples.labels.size())) = candidate.features;
    const bool is_person = frame.person_box && frame.person_box->Contains(candidate.centroid);
    samples.labels.push_back(is_person ? 1 : -1);
  }
  const auto persons = std::count(samples.labels.begin(), samples.labels.end(), 1);
  for (const std::int8_t label : samples.labels)
    samples.weights.push_back(label > 0 ? 1.0F / static_cast<float>(persons) : 1.0F);
  return samples;
}

}  // namespace

SegmentedMap SegmentObserved(const ObservedFrame& frame, const CellModel& cells,
                             const TrainingConfig& config) {
  const ForegroundMap foreground = BackgroundSubtractor().Subtract(frame.map);
  return SegmentCells(foreground, cells, config.segmentation);
}

ClusterSamples JoinSamples(std::span<const ClusterSamples> parts) {
  Eigen::Index rows = 0;
  for (const ClusterSamples& part : parts) rows += part.features.rows();
  ClusterSamples samples;
  samples.features.resize(rows, parts.empty() ? 0 : parts[0].features.cols());
  rows = 0;
  for (const ClusterSamples& part : parts) {
    samples.features.middleRows(rows, part.features.rows()) = part.features;
    samples.labels.insert(samples.labels.end(), part.labels.begin(), part.labels.end());
    samples.weights.insert(samples.weights.end(), part.weights.begin(), part.weights.end());
    rows += part.features.rows();
  }
  return samples;
}

ClusterSamples CollectClusterSamples(std::span<const ObservedFrame* const> frames,
                                     const CellModel& cells, const ClusterModel& model,
                                     const TrainingConfig& config, int jobs,
                                     const TrainingProgress& progress) {
  std::vector<ClusterSamples> parts(frames.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(frames.size()), jobs, [&](int i) {
    parts[i] = SampleFrame(*frames[i], cells, model, config);
    progress("cluster features", static_cast<double>(++done) / static_cast<double>(frames.size()));
  });
  return JoinSamples(parts);
}

}  // namespace fallen
