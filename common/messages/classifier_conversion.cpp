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

network_t NetworkToMessage(const FeatureNetwork& network) {
  network_t message{};
  message.feature_count = static_cast<std::int32_t>(network.feature_count());
  message.mean.assign(network.mean.begin(), network.mean.end());
  message.scale.assign(network.scale.begin(), network.scale.end());
  message.layer_count = static_cast<std::int32_t>(network.layers.size());
  for (const FeatureNetwork::Layer& layer : network.layers) {
    network_layer_t& of_layer = message.layers.emplace_back();
    of_layer.input_count = static_cast<std::int32_t>(layer.weights.rows());
    of_layer.output_count = static_cast<std::int32_t>(layer.weights.cols());
    of_layer.weight = RowsOfMatrix(layer.weights);
    of_layer.bias.assign(layer.bias.begin(), layer.bias.end());
  }
  return message;
}

FeatureNetwork NetworkFromMessage(const std::string& field, const network_t& message) {
  const auto row_of = [](const std::vector<float>& values) {
    return Eigen::Map<const Eigen::RowVectorXf>(values.data(),
                                                static_cast<Eigen::Index>(values.size()));
  };
  for (const std::size_t count : {message.mean.size(), message.scale.size()})
    checks::Count(field + ".feature_count", message.feature_count, count);
  checks::Count(field + ".layer_count", message.layer_count, message.layers.size());
  FeatureNetwork network;
  network.mean = row_of(message.mean);
  network.scale = row_of(message.scale);
  for (const network_layer_t& layer : message.layers) {
    checks::Count(field + ".output_count", layer.output_count, layer.bias.size());
    network.layers.push_back({MatrixFromRows<FeatureMatrix>(field + ".weight", layer.weight,
                                                            layer.input_count, layer.output_count),
                              row_of(layer.bias)});
  }
  return network;
}

}  // namespace fallen
