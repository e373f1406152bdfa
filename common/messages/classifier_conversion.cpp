// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/classifier_conversion.hpp"

namespace fallen {

trees_t TreesToMessage(const BoostedTrees& trees) {
  trees_t message{};
  message.feature_count = trees.feature_count;
  message.root = trees.roots;
  message.tree_count = static_cast<std::int32_t>(trees.roots.size());
  message.node_count = static_cast<std::int32_t>(trees.nodes.size());
  for (const BoostedTrees::Node& node : trees.nodes) {
    message.node_feature.push_back(node.feature);
    message.node_threshold.push_back(node.threshold);
    message.node_left.push_back(node.left);
    message.node_value.push_back(node.value);
  }
  return message;
}

BoostedTrees TreesFromMessage(const std::string& field, const trees_t& message) {
  checks::Count(field + ".tree_count", message.tree_count, message.root.size());
  for (const std::size_t count : {message.node_feature.size(), message.node_threshold.size(),
                                  message.node_left.size(), message.node_value.size()})
    checks::Count(field + ".node_count", message.node_count, count);
  BoostedTrees trees;
  trees.feature_count = message.feature_count;
  trees.roots = message.root;
  for (std::size_t i = 0; i < message.node_feature.size(); ++i)
    trees.nodes.push_back({message.node_feature[i], message.node_threshold[i], message.node_left[i],
                           message.node_value[i]});
  return trees;
}

}  // namespace fallen
