// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/feature_binning.hpp"
#include "fallen/segmentation/parallel_for.hpp"
#include "fallen/segmentation/tree_growing.hpp"

namespace fallen {
namespace {

// A tree without an error would get an infinite vote; it gets that of an error this large.
constexpr double kMinError = 1e-10;
// Gains of the exponential loss below this share end the training: rounding, not learning.
constexpr double kMinLossGain = 1e-12;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("boosted_trees: " + what);
}

void CheckSamples(const Eigen::Ref<const FeatureMatrix>& features,
                  std::span<const std::int8_t> labels, std::span<const float> weights) {
  const auto count = static_cast<std::size_t>(features.rows());
  if (features.cols() < 1) Fail("the samples have no features");
  if (labels.size() != count)
    Fail("got " + std::to_string(labels.size()) + " labels for " + std::to_string(count) +
         " samples");
  if (!weights.empty() && weights.size() != count)
    Fail("got " + std::to_string(weights.size()) + " weights for " + std::to_string(count) +
         " samples");
  if (!features.allFinite()) Fail("a feature is not finite");
  for (const float weight : weights)
    if (!(weight > 0) || !std::isfinite(weight))
      Fail("a weight is " + std::to_string(weight) + ", must be > 0 and finite");
  for (const std::int8_t label : labels)
    if (label != 1 && label != -1)
      Fail("a label is " + std::to_string(label) + ", must be +1 or -1");
  if (std::count(labels.begin(), labels.end(), 1) == 0) Fail("no sample is labelled +1");
  if (std::count(labels.begin(), labels.end(), -1) == 0) Fail("no sample is labelled -1");
}

std::vector<double> NormalizedWeights(std::span<const float> weights, std::size_t count) {
  std::vector<double> normalized(count, 1.0);
  std::copy(weights.begin(), weights.end(), normalized.begin());
  const double sum = std::accumulate(normalized.begin(), normalized.end(), 0.0);
  for (double& weight : normalized) weight /= sum;
  return normalized;
}

bool IsLeaf(const BoostedTrees::Node& node) { return node.feature < 0; }

// [Freund95]: each leaf says the class that weighs more in it, and the tree votes with
// ln((1 - error) / error) / 2, half of [Freund95]'s ln(1 / beta): the same decision, and the
// weights are then multiplied by exp(-y vote) as in the other variants.
void VoteDiscrete(GrownTree& tree) {
  double error = 0;
  double total = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (!IsLeaf(tree.nodes[i])) continue;
    error += std::min(tree.weights[i].positive, tree.weights[i].negative);
    total += tree.weights[i].positive + tree.weights[i].negative;
  }
  const double clamped = std::max(error / total, kMinError);
  const double vote = 0.5 * std::log((1 - clamped) / clamped);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (IsLeaf(tree.nodes[i]))
      tree.nodes[i].value =
          static_cast<float>(tree.weights[i].positive > tree.weights[i].negative ? vote : -vote);
}

// Half the log-odds, smoothed by one sample's share as [Schapire99] Sec. 4.2 has it.
void VoteReal(GrownTree& tree, double smoothing) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (IsLeaf(tree.nodes[i]))
      tree.nodes[i].value =
          static_cast<float>(0.5 * std::log((tree.weights[i].positive + smoothing) /
                                            (tree.weights[i].negative + smoothing)));
}

// The weighted mean label.
void VoteGentle(GrownTree& tree) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto& [positive, negative] = tree.weights[i];
    if (IsLeaf(tree.nodes[i]) && positive + negative > 0)
      tree.nodes[i].value = static_cast<float>((positive - negative) / (positive + negative));
  }
}

void Vote(GrownTree& tree, BoostingVariant variant, std::size_t sample_count) {
  switch (variant) {
    case BoostingVariant::kDiscrete:
      return VoteDiscrete(tree);
    case BoostingVariant::kReal:
      return VoteReal(tree, 1.0 / static_cast<double>(sample_count));
    case BoostingVariant::kGentle:
      return VoteGentle(tree);
  }
}

// By how much the tree's votes multiply the exponential loss: below 1, or it has learnt nothing.
double LossFactor(const GrownTree& tree) {
  double factor = 0;
  double total = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (!IsLeaf(tree.nodes[i])) continue;
    const double vote = tree.nodes[i].value;
    factor +=
        tree.weights[i].positive * std::exp(-vote) + tree.weights[i].negative * std::exp(vote);
    total += tree.weights[i].positive + tree.weights[i].negative;
  }
  return factor / total;
}

void Append(const GrownTree& tree, BoostedTrees& model) {
  const auto offset = static_cast<std::int32_t>(model.nodes.size());
  model.roots.push_back(offset);
  for (BoostedTrees::Node node : tree.nodes) {
    if (!IsLeaf(node)) node.left += offset;
    model.nodes.push_back(node);
  }
}

}  // namespace

BoostedTrees TrainBoostedTrees(const Eigen::Ref<const FeatureMatrix>& features,
                               std::span<const std::int8_t> labels, std::span<const float> weights,
                               const BoostingConfig& config,
                               const std::function<void(const BoostingProgress&)>& progress,
                               int threads) {
  config.Validate();
  CheckSamples(features, labels, weights);
  threads = ThreadCount(threads);
  const std::size_t count = labels.size();
  const BinnedFeatures binned = BinFeatures(features, config.threshold_bins, threads);
  const std::vector<double> given = NormalizedWeights(weights, count);
  std::vector<std::uint8_t> is_positive(count);
  std::transform(labels.begin(), labels.end(), is_positive.begin(),
                 [](std::int8_t label) { return static_cast<std::uint8_t>(label > 0); });
  const TreeGrowingConfig growing{config.max_depth, config.min_leaf_weight,
                                  config.variant == BoostingVariant::kReal
                                      ? SplitCriterion::kExponentialLoss
                                      : SplitCriterion::kGini};

  BoostedTrees model;
  model.feature_count = static_cast<std::int32_t>(features.cols());
  std::vector<double> current = given;  // sums to the exponential loss's share of this round: 1
  std::vector<double> sums(count, 0.0);
  double loss = 1;
  for (int round = 1; round <= config.rounds; ++round) {
    GrownTree tree = GrowTree(binned, is_positive, current, growing, threads);
    Vote(tree, config.variant, count);
    for (BoostedTrees::Node& node : tree.nodes)
      node.value *= static_cast<float>(config.learning_rate);
    const double factor = LossFactor(tree);
    // A model has at least one tree, even one that learnt nothing.
    if (round > 1 && factor > 1 - kMinLossGain) break;
    Append(tree, model);
    loss *= factor;

    double error = 0;
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double vote = tree.nodes[tree.leaf_indices[i]].value;
      sums[i] += vote;
      if (is_positive[i] != (sums[i] > 0)) error += given[i];
      current[i] *= std::exp(is_positive[i] ? -vote : vote);
      total += current[i];
    }
    for (double& weight : current) weight /= total;
    if (progress) progress({round, error, loss});
  }
  return model;
}

}  // namespace fallen
