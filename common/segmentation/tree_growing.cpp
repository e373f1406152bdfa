// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_growing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fallen/segmentation/parallel_for.hpp"

namespace fallen {
namespace {

// Values of a feature's bin: weight of the negative, then of the positive samples.
constexpr int kBins = 256;
constexpr int kFeatureStride = 2 * kBins;
// Features whose histograms are filled in one pass over the samples: eight of them, 4 KB each, fit
// the first-level cache, and their sums do not wait for each other.
constexpr int kFeatureBlock = 8;
// A split must gain this share of its node's weight: what is less is rounding, for a histogram that
// is the difference of two others is only exact to about the square root of this.
constexpr double kMinGainShare = 1e-7;

struct Sample {
  double weight;
  std::uint32_t index;
  std::uint32_t is_positive;
};

// A node, and its samples: [begin, end) of the one array that holds them all.
struct OpenNode {
  std::int32_t node = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<double> histogram;

  std::size_t size() const { return end - begin; }
};

struct Split {
  double gain = 0;  // 0: none
  int feature = -1;
  int cut = -1;
};

template <int kCount>
void AddToHistograms(std::span<const Sample> samples, const BinnedFeatures& features,
                     int first_feature, double* histogram) {
  const std::uint8_t* columns[kCount];
  for (int f = 0; f < kCount; ++f) columns[f] = features.column(first_feature + f);
  double* first = histogram + static_cast<std::size_t>(first_feature) * kFeatureStride;
  for (const Sample& sample : samples)
    for (int f = 0; f < kCount; ++f)
      first[f * kFeatureStride + 2 * columns[f][sample.index] + sample.is_positive] +=
          sample.weight;
}

double Impurity(SplitCriterion criterion, double positive, double negative) {
  const double product = std::max(0.0, positive) * std::max(0.0, negative);
  if (product <= 0) return 0;
  if (criterion == SplitCriterion::kExponentialLoss) return 2 * std::sqrt(product);
  return 2 * product / (positive + negative);
}

Split BestSplitOfFeature(const double* histogram, int feature, int cut_count,
                         const GrownTree::LeafWeights& node, const TreeGrowingConfig& config,
                         double min_leaf_weight) {
  const double impurity = Impurity(config.criterion, node.positive, node.negative);
  Split best{kMinGainShare * (node.positive + node.negative), -1, -1};
  GrownTree::LeafWeights left;
  for (int cut = 0; cut < cut_count; ++cut) {
    left.negative += histogram[2 * cut];
    left.positive += histogram[2 * cut + 1];
    const GrownTree::LeafWeights right{node.positive - left.positive,
                                       node.negative - left.negative};
    if (left.positive + left.negative < min_leaf_weight) continue;
    if (right.positive + right.negative < min_leaf_weight) break;
    const double gain = impurity - Impurity(config.criterion, left.positive, left.negative) -
                        Impurity(config.criterion, right.positive, right.negative);
    if (gain > best.gain) best = {gain, feature, cut};
  }
  return best.feature < 0 ? Split{} : best;
}

class TreeGrower {
 public:
  TreeGrower(const BinnedFeatures& features, std::span<const std::uint8_t> is_positive,
             std::span<const double> weights, const TreeGrowingConfig& config, int threads)
      : features_(features), config_(config), threads_(threads) {
    samples_.reserve(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i)
      samples_.push_back({weights[i], static_cast<std::uint32_t>(i), is_positive[i]});
    scratch_.resize(samples_.size());
    tree_.leaf_indices.resize(samples_.size());
    level_.push_back({AddNode(0, samples_.size()), 0, samples_.size(), {}});
    const GrownTree::LeafWeights& root = tree_.weights.front();
    min_leaf_weight_ = config.min_leaf_weight * (root.positive + root.negative);
  }

  GrownTree Grow() {
    for (int depth = 0; depth < config_.max_depth && !level_.empty(); ++depth) {
      FillHistograms();
      SplitLevel(FindSplits());
    }
    for (const OpenNode& open : level_) CloseNode(open);
    return std::move(tree_);
  }

 private:
  std::int32_t AddNode(std::size_t begin, std::size_t end) {
    GrownTree::LeafWeights weights;
    for (std::size_t k = begin; k < end; ++k)
      (samples_[k].is_positive ? weights.positive : weights.negative) += samples_[k].weight;
    tree_.nodes.emplace_back();
    tree_.weights.push_back(weights);
    return static_cast<std::int32_t>(tree_.nodes.size()) - 1;
  }

  void CloseNode(const OpenNode& open) {
    for (std::size_t k = open.begin; k < open.end; ++k)
      tree_.leaf_indices[samples_[k].index] = open.node;
  }

  // A level is the root, or pairs of siblings. Of two siblings only the one with fewer samples is
  // counted; the other's histogram is their parent's, which it was handed, less its sibling's.
  void FillHistograms() {
    const int feature_count = features_.feature_count();
    for (OpenNode& open : level_)
      if (open.histogram.empty())
        open.histogram.assign(static_cast<std::size_t>(feature_count) * kFeatureStride, 0.0);
    const int blocks = (feature_count + kFeatureBlock - 1) / kFeatureBlock;
    const int pairs = static_cast<int>(level_.size() + 1) / 2;
    ParallelFor(pairs * blocks, threads_, [&](int task) {
      const auto pair = static_cast<std::size_t>(task / blocks);
      const int first = (task % blocks) * kFeatureBlock;
      const int last = std::min(first + kFeatureBlock, feature_count);
      if (level_.size() == 1) return Count(level_[0], first, last);
      OpenNode& a = level_[2 * pair];
      OpenNode& b = level_[2 * pair + 1];
      OpenNode& smaller = a.size() <= b.size() ? a : b;
      OpenNode& larger = a.size() <= b.size() ? b : a;
      Count(smaller, first, last);
      for (int k = first * kFeatureStride; k < last * kFeatureStride; ++k)
        larger.histogram[k] -= smaller.histogram[k];
    });
  }

  void Count(OpenNode& open, int first, int last) {
    const std::span<const Sample> samples = std::span(samples_).subspan(open.begin, open.size());
    if (last - first == kFeatureBlock)
      return AddToHistograms<kFeatureBlock>(samples, features_, first, open.histogram.data());
    for (int feature = first; feature < last; ++feature)
      AddToHistograms<1>(samples, features_, feature, open.histogram.data());
  }

  std::vector<Split> FindSplits() const {
    std::vector<Split> splits;
    for (const OpenNode& open : level_) {
      Split best;
      for (int feature = 0; feature < features_.feature_count(); ++feature) {
        const Split split = BestSplitOfFeature(
            open.histogram.data() + static_cast<std::size_t>(feature) * kFeatureStride, feature,
            static_cast<int>(features_.cuts[feature].size()), tree_.weights[open.node], config_,
            min_leaf_weight_);
        if (split.gain > best.gain) best = split;
      }
      splits.push_back(best);
    }
    return splits;
  }

  void SplitLevel(const std::vector<Split>& splits) {
    std::vector<std::size_t> middles(level_.size());
    ParallelFor(static_cast<int>(level_.size()), threads_, [&](int i) {
      if (splits[i].feature >= 0) middles[i] = Partition(level_[i], splits[i]);
    });
    std::vector<OpenNode> next;
    for (std::size_t i = 0; i < level_.size(); ++i) {
      OpenNode& open = level_[i];
      if (splits[i].feature < 0 || middles[i] == open.begin || middles[i] == open.end) {
        CloseNode(open);
        continue;
      }
      OpenNode left{AddNode(open.begin, middles[i]), open.begin, middles[i], {}};
      OpenNode right{AddNode(middles[i], open.end), middles[i], open.end, {}};
      BoostedTrees::Node& node = tree_.nodes[open.node];
      node.feature = splits[i].feature;
      node.threshold = features_.cuts[splits[i].feature][splits[i].cut];
      node.left = left.node;
      (left.size() <= right.size() ? right : left).histogram = std::move(open.histogram);
      next.push_back(std::move(left));
      next.push_back(std::move(right));
    }
    level_ = std::move(next);
  }

  // Moves the samples that go left before those that go right; both keep their order, so that sums
  // and memory accesses run over ascending samples. Returns where the right ones begin.
  std::size_t Partition(const OpenNode& open, const Split& split) {
    const std::uint8_t* column = features_.column(split.feature);
    std::size_t left = open.begin;
    std::size_t right = open.begin;
    for (std::size_t k = open.begin; k < open.end; ++k) {
      const Sample sample = samples_[k];
      if (column[sample.index] <= split.cut) {
        samples_[left++] = sample;
        continue;
      }
      scratch_[right++] = sample;
    }
    std::copy(scratch_.begin() + open.begin, scratch_.begin() + right, samples_.begin() + left);
    return left;
  }

  const BinnedFeatures& features_;
  const TreeGrowingConfig config_;
  const int threads_;
  double min_leaf_weight_ = 0;
  std::vector<Sample> samples_;
  std::vector<Sample> scratch_;
  std::vector<OpenNode> level_;
  GrownTree tree_;
};

}  // namespace

GrownTree GrowTree(const BinnedFeatures& features, std::span<const std::uint8_t> is_positive,
                   std::span<const double> weights, const TreeGrowingConfig& config, int threads) {
  return TreeGrower(features, is_positive, weights, config, threads).Grow();
}

}  // namespace fallen
