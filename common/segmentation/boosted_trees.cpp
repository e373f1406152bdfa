// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/boosted_trees.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// Rows walked through a tree side by side. A walk is a chain of dependent loads; eight of them hide
// each other's latency and fit the registers.
constexpr int kLanes = 8;
// Deepest tree that is filled up to a complete one: 1 024 leaves, as deep as training goes.
constexpr int kMaxCompleteDepth = 10;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("boosted_trees: " + what);
}

// A tree filled up to a complete one, where the children of node n are 2n + 1 and 2n + 2: all rows
// take the same number of steps, no step branches, and a step loads nothing but its feature and
// threshold. A leaf that lies higher is reached through nodes that always send left.
struct CompleteTree {
  int depth = 0;
  std::size_t first_decision = 0;
  std::size_t first_vote = 0;
};

struct Decision {
  std::uint32_t feature = 0;  // times kLanes
  float threshold = std::numeric_limits<float>::infinity();
};

struct PreparedTrees {
  std::vector<CompleteTree> complete;
  std::vector<Decision> decisions;
  std::vector<float> votes;
  std::vector<std::int32_t> deep_roots;  // of trees too deep to be filled up
  double largest_sum = 0;                // of the trees' largest absolute votes
};

void FillUp(const BoostedTrees& model, std::int32_t from, std::uint32_t at, CompleteTree tree,
            PreparedTrees& prepared) {
  const std::uint32_t decision_count = (1U << tree.depth) - 1;
  const BoostedTrees::Node& node = model.nodes[from];
  if (node.feature >= 0) {
    prepared.decisions[tree.first_decision + at] = {
        static_cast<std::uint32_t>(node.feature) * kLanes, node.threshold};
    FillUp(model, node.left, 2 * at + 1, tree, prepared);
    FillUp(model, node.left + 1, 2 * at + 2, tree, prepared);
    return;
  }
  while (at < decision_count) at = 2 * at + 1;
  prepared.votes[tree.first_vote + at - decision_count] = node.value;
}

PreparedTrees Prepare(const BoostedTrees& model) {
  std::vector<int> depth(model.nodes.size(), 0);
  std::vector<float> largest(model.nodes.size(), 0);
  // Children come after their parent: from the back, both are known when the parent is reached.
  for (std::size_t i = model.nodes.size(); i-- > 0;) {
    const BoostedTrees::Node& node = model.nodes[i];
    largest[i] = std::abs(node.value);
    if (node.feature < 0) continue;
    depth[i] = 1 + std::max(depth[node.left], depth[node.left + 1]);
    largest[i] = std::max(largest[node.left], largest[node.left + 1]);
  }
  PreparedTrees prepared;
  for (const std::int32_t root : model.roots) {
    prepared.largest_sum += largest[root];
    if (depth[root] > kMaxCompleteDepth) {
      prepared.deep_roots.push_back(root);
      continue;
    }
    const CompleteTree tree{depth[root], prepared.decisions.size(), prepared.votes.size()};
    const std::size_t leaf_count = std::size_t{1} << tree.depth;
    prepared.decisions.resize(tree.first_decision + leaf_count - 1);
    prepared.votes.resize(tree.first_vote + leaf_count);
    FillUp(model, root, 0, tree, prepared);
    prepared.complete.push_back(tree);
  }
  return prepared;
}

// Adds up the votes for `kLanes` rows, given as a block: value of feature f, row l at f * kLanes +
// l.
std::array<double, kLanes> SumVotes(const PreparedTrees& trees, const float* block) {
  std::array<double, kLanes> sums{};
  for (const CompleteTree& tree : trees.complete) {
    const Decision* decisions = trees.decisions.data() + tree.first_decision;
    std::array<std::uint32_t, kLanes> at{};
    for (int step = tree.depth; step > 0; --step)
#pragma GCC unroll 8
      for (int lane = 0; lane < kLanes; ++lane) {
        const Decision& decision = decisions[at[lane]];
        const float value = block[std::size_t{decision.feature} + lane];
        at[lane] = 2 * at[lane] + 1 + (value > decision.threshold ? 1U : 0U);
      }
    const float* votes =
        trees.votes.data() + tree.first_vote - ((std::size_t{1} << tree.depth) - 1);
    for (int lane = 0; lane < kLanes; ++lane) sums[lane] += votes[at[lane]];
  }
  return sums;
}

double SumDeepVotes(const BoostedTrees& model, const std::vector<std::int32_t>& roots,
                    const float* row) {
  double sum = 0;
  for (std::int32_t at : roots) {
    while (model.nodes[at].feature >= 0)
      at =
          model.nodes[at].left + (row[model.nodes[at].feature] > model.nodes[at].threshold ? 1 : 0);
    sum += model.nodes[at].value;
  }
  return sum;
}

}  // namespace

void BoostedTrees::Validate() const {
  if (feature_count < 1)
    Fail("feature_count is " + std::to_string(feature_count) + ", must be >= 1");
  const auto count = static_cast<std::int64_t>(nodes.size());
  for (std::size_t t = 0; t < roots.size(); ++t)
    if (roots[t] < 0 || roots[t] >= count)
      Fail("root " + std::to_string(t) + " is node " + std::to_string(roots[t]) +
           ", must be in [0, " + std::to_string(count) + ")");
  for (std::int64_t i = 0; i < count; ++i) {
    const Node& node = nodes[static_cast<std::size_t>(i)];
    const std::string name = "node " + std::to_string(i);
    if (!std::isfinite(node.value) || !std::isfinite(node.threshold))
      Fail(name + " has a value or threshold that is not finite");
    if (node.feature == -1) continue;
    if (node.feature < 0 || node.feature >= feature_count)
      Fail(name + " asks for feature " + std::to_string(node.feature) + ", must be in [-1, " +
           std::to_string(feature_count) + ")");
    if (node.left <= i || node.left >= count - 1)
      Fail(name + " has its children at " + std::to_string(node.left) + ", must be in (" +
           std::to_string(i) + ", " + std::to_string(count - 1) + ")");
  }
}

void BoostingConfig::Validate() const {
  if (EnumName(variant) == "unknown")
    Fail("variant is " + std::to_string(static_cast<int>(variant)) + ", must be in [0, 2]");
  if (rounds < 1) Fail("rounds is " + std::to_string(rounds) + ", must be >= 1");
  if (max_depth < 1 || max_depth > 10)
    Fail("max_depth is " + std::to_string(max_depth) + ", must be in [1, 10]");
  if (!(min_leaf_weight >= 0 && min_leaf_weight < 0.5))
    Fail("min_leaf_weight is " + std::to_string(min_leaf_weight) + ", must be in [0, 0.5)");
  if (threshold_bins < 2 || threshold_bins > 256)
    Fail("threshold_bins is " + std::to_string(threshold_bins) + ", must be in [2, 256]");
}

std::vector<float> PredictScores(const BoostedTrees& model,
                                 const Eigen::Ref<const FeatureMatrix>& features) {
  if (features.cols() != model.feature_count)
    Fail("the rows have " + std::to_string(features.cols()) + " features, the model expects " +
         std::to_string(model.feature_count));
  if (!features.allFinite()) Fail("a feature is not finite");

  const Eigen::Index count = features.rows();
  std::vector<float> scores(static_cast<std::size_t>(count), 0.0F);
  const PreparedTrees trees = Prepare(model);
  if (trees.largest_sum <= 0) return scores;

  std::vector<float> block(static_cast<std::size_t>(model.feature_count) * kLanes);
  for (Eigen::Index begin = 0; begin < count; begin += kLanes) {
    const Eigen::Index lanes = std::min<Eigen::Index>(kLanes, count - begin);
    for (Eigen::Index lane = 0; lane < lanes; ++lane) {
      const float* row = features.row(begin + lane).data();
      for (int f = 0; f < model.feature_count; ++f) block[f * kLanes + lane] = row[f];
    }
    const std::array<double, kLanes> sums = SumVotes(trees, block.data());
    for (Eigen::Index lane = 0; lane < lanes; ++lane) {
      const double deep = SumDeepVotes(model, trees.deep_roots, features.row(begin + lane).data());
      scores[static_cast<std::size_t>(begin + lane)] =
          static_cast<float>((sums[lane] + deep) / trees.largest_sum);
    }
  }
  return scores;
}

}  // namespace fallen
