// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_classification.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fallen/classification/cluster_classifier.hpp"
#include "fallen/classification/cluster_features.hpp"
#include "fallen/classification/cluster_parts.hpp"
#include "fallen/classification/hypothesis_selection.hpp"

namespace fallen {
namespace {

// Rows of the codebook are unit vectors to about float's precision.
constexpr float kUnitTolerance = 1e-4F;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("cluster_classification: " + what);
}

PersonHypothesis MakeHypothesis(const SegmentedMap& segmented, const ClusterCandidate& candidate,
                                double probability, double min_probability) {
  PersonHypothesis hypothesis;
  for (const std::int32_t index : candidate.cluster.cells)
    hypothesis.mean_score += segmented.cells[index].score;
  hypothesis.mean_score /= static_cast<double>(candidate.cluster.cells.size());
  hypothesis.cell_count = static_cast<std::int32_t>(candidate.cluster.cells.size());
  hypothesis.centroid = candidate.centroid;
  hypothesis.box = candidate.box;
  hypothesis.mahalanobis_distance = candidate.mahalanobis_distance;
  hypothesis.probability = probability;
  hypothesis.is_person = hypothesis.probability >= min_probability;
  return hypothesis;
}

}  // namespace

bool Decision::operator==(const Decision& other) const {
  return frame == other.frame && T_map_camera.matrix() == other.T_map_camera.matrix() &&
         view == other.view && min_probability == other.min_probability &&
         hypotheses == other.hypotheses;
}

void ClusterModel::Validate() const {
  iron.Validate();
  if (codebook.rows() < 1) Fail("the codebook is empty");
  if (codebook.cols() != iron.dimension())
    Fail("the codebook's rows have " + std::to_string(codebook.cols()) + " values, must be " +
         std::to_string(iron.dimension()));
  for (Eigen::Index i = 0; i < codebook.rows(); ++i)
    if (!(std::abs(codebook.row(i).norm() - 1) <= kUnitTolerance))
      Fail("row " + std::to_string(i) + " of the codebook is not a unit vector");
  if (!(alpha >= -1 && alpha < 1))
    Fail("alpha is " + std::to_string(alpha) + ", must be in [-1, 1)");
  if (gaussian.mean().size() != codebook.rows())
    Fail("the gaussian has " + std::to_string(gaussian.mean().size()) +
         " dimensions, must be the codebook's " + std::to_string(codebook.rows()));
  calibration.Validate();
  network.Validate();
  if (!(network_share >= 0 && network_share <= 1))
    Fail("network_share is " + std::to_string(network_share) + ", must be in [0, 1]");
  if (trees.roots.empty()) {
    if (!network.empty()) Fail("there is a network, but no trees that it judges beside");
    return;
  }
  trees.Validate();
  const int expected = ClusterFeatureCount(iron, codebook.rows());
  if (trees.feature_count != expected)
    Fail("the trees take " + std::to_string(trees.feature_count) + " features, must be " +
         std::to_string(expected));
  if (!network.empty() && network.feature_count() != expected)
    Fail("the network takes " + std::to_string(network.feature_count()) + " features, must be " +
         std::to_string(expected));
}

void ClassificationConfig::Validate() const {
  if (!(false_positives_per_frame >= 0) || !std::isfinite(false_positives_per_frame))
    Fail("false_positives_per_frame is " + std::to_string(false_positives_per_frame) +
         ", must be >= 0 and finite");
  if (!(min_separation_m >= 0) || !std::isfinite(min_separation_m))
    Fail("min_separation_m is " + std::to_string(min_separation_m) + ", must be >= 0 and finite");
}

Decision ClassifyClusters(const SegmentedMap& segmented, const ClusterModel& model,
                          const ClassificationConfig& config) {
  Decision decision;
  ClusterClassifier(model).Classify(segmented, config, decision);
  return decision;
}

ClusterClassifier::ClusterClassifier(ClusterModel model)
    : model_(std::move(model)), scorer_(model_) {}

void ClusterClassifier::Classify(const SegmentedMap& segmented, const ClassificationConfig& config,
                                 Decision& decision) {
  config.Validate();
  if (!(segmented.iron == model_.iron))
    Fail("the descriptors were computed with other settings than the model's");

  decision.hypotheses.clear();
  decision.frame = segmented.frame;
  decision.T_map_camera = segmented.T_map_camera;
  decision.view = segmented.view;
  decision.min_probability = model_.calibration.MinProbability(config.false_positives_per_frame);
  of_one_cluster_.clear();
  std::int32_t whole = 0;
  const auto take_best = [&] {
    // Parts of one cluster that are nearer to each other are of the same person.
    KeepBestOfEachPlace(of_one_cluster_, kPersonLength_m);
    decision.hypotheses.insert(decision.hypotheses.end(), of_one_cluster_.begin(),
                               of_one_cluster_.end());
    of_one_cluster_.clear();
  };
  const std::span<const ClusterCandidate> candidates = finder_.Find(segmented, model_);
  const std::span<const double> evidence = scorer_.Score(candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].whole != whole) take_best();
    whole = candidates[i].whole;
    of_one_cluster_.push_back(MakeHypothesis(segmented, candidates[i],
                                             model_.calibration.Probability(evidence[i]),
                                             decision.min_probability));
  }
  take_best();
  KeepBestOfEachPlace(decision.hypotheses, config.min_separation_m);
}

}  // namespace fallen
