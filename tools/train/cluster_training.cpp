// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/cluster_training.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "fallen/classification/cluster_candidates.hpp"
#include "fallen/classification/cluster_classifier.hpp"
#include "fallen/classification/soft_threshold_encoding.hpp"
#include "fallen/evaluation/frame_outcome.hpp"
#include "fallen/segmentation/parallel_for.hpp"
#include "tools/train/operating_points.hpp"

namespace fallen {
namespace {

bool IsPerson(const SegmentedMap& segmented, const CellCluster& cluster,
              const std::optional<OrientedBox>& person_box, double min_share) {
  if (!person_box) return false;
  std::size_t inside = 0;
  for (const std::int32_t i : cluster.cells)
    if (person_box->Contains(segmented.cells[i].mean.cast<double>())) ++inside;
  return static_cast<double>(inside) >= min_share * static_cast<double>(cluster.cells.size());
}

IronDescriptors::Matrix ThinRows(const IronDescriptors::Matrix& rows, Eigen::Index wanted) {
  if (rows.rows() <= wanted) return rows;
  IronDescriptors::Matrix kept(wanted, rows.cols());
  for (Eigen::Index i = 0; i < wanted; ++i) kept.row(i) = rows.row(i * rows.rows() / wanted);
  return kept;
}

// Of the samples, persons and others weighing the same; in all 1.
std::vector<float> BalancedWeights(const ClusterSamples& samples) {
  const auto persons = std::count(samples.labels.begin(), samples.labels.end(), 1);
  const auto others = static_cast<std::int64_t>(samples.labels.size()) - persons;
  if (persons == 0 || others == 0)
    throw std::runtime_error("segmentation finds " + std::to_string(persons) + " persons and " +
                             std::to_string(others) +
                             " other clusters in the training frames, expected both");
  double person_weight = 0, other_weight = 0;
  for (std::size_t i = 0; i < samples.labels.size(); ++i)
    (samples.labels[i] > 0 ? person_weight : other_weight) += samples.weights[i];
  std::vector<float> weights;
  for (std::size_t i = 0; i < samples.labels.size(); ++i)
    weights.push_back(0.5F * samples.weights[i] /
                      static_cast<float>(samples.labels[i] > 0 ? person_weight : other_weight));
  return weights;
}

}  // namespace

ClusterTraining TrainClusterModel(std::span<const ObservedFrame* const> frames,
                                  const IronDescriptors::Matrix& person_descriptors,
                                  const CellModel& cells, const TrainingConfig& config, int jobs,
                                  const TrainingProgress& progress) {
  ClusterTraining training;
  ClusterModel& model = training.model;
  model.iron = config.iron;
  model.alpha = config.sampling.alpha;
  model.codebook =
      TrainGrowingNeuralGas(ThinRows(person_descriptors, config.sampling.codebook_cells),
                            config.codebook, [&](double share) { progress("codebook", share); });

  std::vector<std::vector<Eigen::VectorXd>> codes(frames.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(frames.size()), jobs, [&](int i) {
    progress("clusters", static_cast<double>(++done) / static_cast<double>(frames.size()));
    if (!frames[i]->is_positive()) return;
    const bool isolates = config.sampling.positives == PositiveCells::kIsolated;
    const SegmentedMap segmented =
        SegmentObserved(isolates ? IsolatePerson(*frames[i]) : *frames[i], cells, config);
    for (const CellCluster& cluster : segmented.clusters)
      if (IsPerson(segmented, cluster, frames[i]->person_box, config.sampling.min_person_share))
        codes[i].push_back(EncodeCluster(cluster.MemberDescriptors(), model.codebook, model.alpha));
  });
  for (const auto& part : codes) training.person_clusters += static_cast<std::int64_t>(part.size());
  if (training.person_clusters < 2)
    throw std::runtime_error("segmentation finds " + std::to_string(training.person_clusters) +
                             " clusters of persons in the training frames, expected 2 or more");
  Eigen::MatrixXd all(training.person_clusters, model.codebook.rows());
  Eigen::Index row = 0;
  for (const auto& part : codes)
    for (const Eigen::VectorXd& code : part) all.row(row++) = code.transpose();
  const MahalanobisFit fit = FitMahalanobis(all);
  model.gaussian = fit.model;
  training.shrinkage = fit.shrinkage;
  return training;
}

BoostedTrees TrainClusterTrees(const ClusterSamples& samples, const BoostingConfig& config,
                               int jobs, const TrainingProgress& progress) {
  const std::vector<float> weights = BalancedWeights(samples);
  return TrainBoostedTrees(
      samples.features, samples.labels, weights, config,
      [&](const BoostingProgress& state) {
        progress("cluster boosting", static_cast<double>(state.round) / config.rounds);
      },
      jobs);
}

FeatureNetwork TrainClusterNetwork(const ClusterSamples& samples,
                                   const NetworkTrainingConfig& config,
                                   const TrainingProgress& progress) {
  return TrainFeatureNetwork(
      samples.features, samples.labels, BalancedWeights(samples), config,
      [&](const NetworkTrainingProgress& state) { progress("cluster network", state.done); });
}

CalibrationResult CalibrateOnFrames(std::span<const ObservedFrame* const> frames,
                                    const CellModel& cells, const ClusterModel& model,
                                    const TrainingConfig& config, int jobs,
                                    const TrainingProgress& progress) {
  struct Judged {
    std::vector<double> evidence;
    std::vector<std::uint8_t> is_person;
    SegmentedMap segmented;
  };
  std::vector<Judged> judged(frames.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(frames.size()), jobs, [&](int i) {
    Judged& frame = judged[i];
    frame.segmented = SegmentObserved(*frames[i], cells, config);
    CandidateFinder finder;
    const std::span<const ClusterCandidate> candidates = finder.Find(frame.segmented, model);
    EvidenceScorer scorer(model);
    const std::span<const double> of_frame = scorer.Score(candidates);
    frame.evidence.assign(of_frame.begin(), of_frame.end());
    for (const ClusterCandidate& candidate : candidates)
      frame.is_person.push_back(IsPerson(frame.segmented, candidate.cluster, frames[i]->person_box,
                                         config.sampling.min_person_share));
    progress("calibration", static_cast<double>(++done) / static_cast<double>(frames.size()));
  });

  std::vector<double> evidence;
  std::vector<std::uint8_t> is_person;
  for (const Judged& frame : judged) {
    evidence.insert(evidence.end(), frame.evidence.begin(), frame.evidence.end());
    is_person.insert(is_person.end(), frame.is_person.begin(), frame.is_person.end());
  }
  CalibrationResult result;
  result.person_clusters = std::count(is_person.begin(), is_person.end(), 1);
  result.other_clusters = static_cast<std::int64_t>(is_person.size()) - result.person_clusters;
  if (result.person_clusters == 0 || result.other_clusters == 0)
    throw std::runtime_error("segmentation finds " + std::to_string(result.person_clusters) +
                             " persons and " + std::to_string(result.other_clusters) +
                             " other clusters in the validation frames, expected both");
  result.calibration = FitCalibration(evidence, is_person);
  // A threshold is needed to judge clusters; the lowest lets the curve see all of them.
  result.calibration.operating_points = {{0.0, 1.0, 0.0}};

  ClusterModel calibrated = model;
  calibrated.calibration = result.calibration;
  ClusterClassifier classifier(std::move(calibrated));
  Decision decision;
  std::vector<FrameOutcome> outcomes;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    classifier.Classify(judged[i].segmented, {}, decision);
    outcomes.push_back(JudgeFrame(decision, frames[i]->person_box, frames[i]->cells_in_box));
  }
  result.tradeoff = ComputeTradeoff(outcomes);
  result.calibration.operating_points = OperatingPointsOf(result.tradeoff);
  return result;
}

}  // namespace fallen
