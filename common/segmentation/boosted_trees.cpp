// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/boosted_trees.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("boosted_trees: " + what);
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
  if (!(learning_rate > 0 && learning_rate <= 1))
    Fail("learning_rate is " + std::to_string(learning_rate) + ", must be in (0, 1]");
  if (!(min_leaf_weight >= 0 && min_leaf_weight < 0.5))
    Fail("min_leaf_weight is " + std::to_string(min_leaf_weight) + ", must be in [0, 0.5)");
  if (threshold_bins < 2 || threshold_bins > 256)
    Fail("threshold_bins is " + std::to_string(threshold_bins) + ", must be in [2, 256]");
}

}  // namespace fallen
