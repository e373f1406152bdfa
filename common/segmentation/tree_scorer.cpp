// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/tree_scorer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Features are put in order so many rows and columns at a time.
constexpr int kPatch = kPortableLanes;
using Patch = Lanes<kPatch>::Floats;
static_assert(kMostLanes % kPatch == 0);

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("boosted_trees: " + what);
}

void Transpose(std::array<Patch, kPatch>& rows) {
  const Patch low01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Patch high01 = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Patch low23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Patch high23 = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  rows[0] = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  rows[2] = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  rows[3] = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

// Writes up to kMostLanes rows column by column: column f of row l at f * kMostLanes + l.
// @return False if a value is not finite.
bool MakeBlock(const float* const* rows, int columns, float* block) {
  Patch not_finite = {};  // sums of zeros, but for infinities and NaN
  int f = 0;
  for (; f + kPatch <= columns; f += kPatch)
    for (int lane = 0; lane < kMostLanes; lane += kPatch) {
      std::array<Patch, kPatch> patch;
      for (int k = 0; k < kPatch; ++k) {
        Load(patch[k], rows[lane + k] + f);
        not_finite += patch[k] * 0.0F;
      }
      Transpose(patch);
      for (int k = 0; k < kPatch; ++k) Store(patch[k], block + (f + k) * kMostLanes + lane);
    }
  for (; f < columns; ++f)
    for (int lane = 0; lane < kMostLanes; ++lane) {
      block[f * kMostLanes + lane] = rows[lane][f];
      not_finite[0] += rows[lane][f] * 0.0F;
    }
  const Patch zero = {};
  return !AnyOf(not_finite != zero);
}

}  // namespace

TreeScorer::TreeScorer(const BoostedTrees& model) : model_(model) {
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
  double largest_sum = 0;
  for (const std::int32_t root : model.roots) largest_sum += double{largest[root]};
  votes_.assign(model.nodes.size(), 0);
  if (largest_sum <= 0) return;
  // Less half a unit a tree: no sum of rounded votes overflows.
  const double steps =
      std::numeric_limits<std::int32_t>::max() - static_cast<double>(model.roots.size());
  for (std::size_t i = 0; i < votes_.size(); ++i)
    votes_[i] = static_cast<std::int32_t>(
        std::lround(steps * (double{model.nodes[i].value} / largest_sum)));
  unit_ = 1 / steps;

  for (const std::int32_t root : model.roots) {
    const BoostedTrees::Node& node = model.nodes[root];
    if (depth[root] <= WalkTree::kDepth)
      walk_trees_.push_back(WalkTreeOf(root));
    else if (depth[root] == WalkTree::kDepth + 1)
      walk_forks_.push_back({WalkTreeOf(node.left), WalkTreeOf(node.left + 1), node.threshold,
                             node.feature * kMostLanes});
    else
      deep_roots_.push_back(root);
  }
}

WalkTree TreeScorer::WalkTreeOf(std::int32_t root) const {
  WalkTree tree;
  tree.threshold.fill(kInfinity);
  tree.feature.fill(0);
  tree.vote.fill(0);
  FillUp(root, 1, tree);
  return tree;
}

void TreeScorer::FillUp(std::int32_t from, std::uint32_t at, WalkTree& tree) const {
  constexpr std::uint32_t kLeaves = 1U << WalkTree::kDepth;
  const BoostedTrees::Node& node = model_.nodes[from];
  if (node.feature < 0) {
    while (at < kLeaves) at *= 2;
    tree.vote[at - kLeaves] = votes_[from];
    return;
  }
  tree.threshold[at] = node.threshold;
  tree.feature[at] = node.feature * kMostLanes;
  FillUp(node.left, 2 * at, tree);
  FillUp(node.left + 1, 2 * at + 1, tree);
}

std::int32_t TreeScorer::VoteOfDeep(std::int32_t root, const float* row) const {
  std::int32_t at = root;
  while (model_.nodes[at].feature >= 0) {
    const BoostedTrees::Node& node = model_.nodes[at];
    at = node.left + (row[node.feature] > node.threshold ? 1 : 0);
  }
  return votes_[at];
}

void TreeScorer::Score(const Eigen::Ref<const FeatureMatrix>& features,
                       std::vector<float>& scores) const {
  if (features.cols() != model_.feature_count)
    Fail("the rows have " + std::to_string(features.cols()) + " features, the model expects " +
         std::to_string(model_.feature_count));
  scores.assign(static_cast<std::size_t>(features.rows()), 0.0F);
  // Kept by the thread, for models of any number of features.
  thread_local std::vector<float> memory;
  memory.resize(static_cast<std::size_t>(model_.feature_count + 1) * kMostLanes);
  void* begin = memory.data();
  std::size_t space = memory.size() * sizeof(float);
  auto* const block = static_cast<float*>(std::align(
      alignof(WalkTree), model_.feature_count * kMostLanes * sizeof(float), begin, space));

  for (Eigen::Index first = 0; first < features.rows(); first += kMostLanes) {
    const Eigen::Index last = features.rows() - 1;
    std::array<const float*, kMostLanes> rows;  // the last one stands for those beyond it
    for (int lane = 0; lane < kMostLanes; ++lane)
      rows[lane] = features.row(std::min(first + lane, last)).data();
    if (!MakeBlock(rows.data(), model_.feature_count, block)) Fail("a feature is not finite");
    std::array<std::int32_t, kMostLanes> sums{};
    AddVotes(walk_trees_.data(), static_cast<int>(walk_trees_.size()), block, sums.data());
    AddVotes(walk_forks_.data(), static_cast<int>(walk_forks_.size()), block, sums.data());
    for (Eigen::Index lane = 0; lane < std::min<Eigen::Index>(kMostLanes, last + 1 - first);
         ++lane) {
      for (const std::int32_t root : deep_roots_) sums[lane] += VoteOfDeep(root, rows[lane]);
      scores[first + lane] = static_cast<float>(std::clamp(unit_ * sums[lane], -1.0, 1.0));
    }
  }
}

std::vector<float> PredictScores(const BoostedTrees& model,
                                 const Eigen::Ref<const FeatureMatrix>& features) {
  std::vector<float> scores;
  TreeScorer(model).Score(features, scores);
  return scores;
}

}  // namespace fallen
