// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/feature_network.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace fallen {
namespace {

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("feature_network: " + what);
}

std::string SizeText(Eigen::Index rows, Eigen::Index columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

}  // namespace

bool FeatureNetwork::Layer::operator==(const Layer& other) const {
  return weights.rows() == other.weights.rows() && weights.cols() == other.weights.cols() &&
         weights == other.weights && bias.size() == other.bias.size() && bias == other.bias;
}

bool FeatureNetwork::operator==(const FeatureNetwork& other) const {
  return mean.size() == other.mean.size() && mean == other.mean &&
         scale.size() == other.scale.size() && scale == other.scale && layers == other.layers;
}

void FeatureNetwork::Validate() const {
  if (layers.empty()) return;
  if (mean.size() == 0 || scale.size() != mean.size())
    Fail(std::to_string(mean.size()) + " means and " + std::to_string(scale.size()) +
         " scales, must be one each a feature");
  if (!mean.allFinite() || !scale.allFinite()) Fail("a mean or scale is not finite");
  Eigen::Index inputs = mean.size();
  float largest = kMaxDeviations;  // that a value can become
  for (const Layer& layer : layers) {
    if (layer.weights.rows() != inputs || layer.weights.cols() == 0 ||
        layer.bias.size() != layer.weights.cols())
      Fail("a layer has " + SizeText(layer.weights.rows(), layer.weights.cols()) + " weights and " +
           std::to_string(layer.bias.size()) + " biases, must be " + std::to_string(inputs) +
           " rows and as many columns as biases");
    if (!layer.weights.allFinite() || !layer.bias.allFinite()) Fail("a weight is not finite");
    largest =
        (largest * layer.weights.cwiseAbs().colwise().sum() + layer.bias.cwiseAbs()).maxCoeff();
    if (!std::isfinite(largest)) Fail("the weights are so large that a score could overflow");
    inputs = layer.weights.cols();
  }
  if (inputs != 1) Fail("the last layer has " + std::to_string(inputs) + " outputs, must be 1");
}

NetworkScorer::NetworkScorer(FeatureNetwork network) : network_(std::move(network)) {
  Eigen::Index widest = network_.feature_count();
  for (const FeatureNetwork::Layer& layer : network_.layers)
    widest = std::max(widest, layer.weights.cols());
  input_.resize(widest);
  output_.resize(widest);
}

void NetworkScorer::Score(const Eigen::Ref<const FeatureMatrix>& features,
                          std::vector<float>& scores) {
  if (network_.empty()) Fail("there is no network to score with");
  if (features.cols() != network_.feature_count())
    Fail("samples have " + std::to_string(features.cols()) + " features, must be " +
         std::to_string(network_.feature_count()));
  scores.resize(static_cast<std::size_t>(features.rows()));
  for (Eigen::Index row = 0; row < features.rows(); ++row) {
    input_.head(features.cols()) = network_.Standardize(features.row(row));
    for (const FeatureNetwork::Layer& layer : network_.layers) {
      auto output = output_.head(layer.bias.size());
      output = layer.bias;
      output.noalias() += input_.head(layer.weights.rows()) * layer.weights;
      if (&layer != &network_.layers.back()) output = output.cwiseMax(0.0F);
      input_.swap(output_);
    }
    scores[static_cast<std::size_t>(row)] = std::tanh(input_[0] / kScoreScale);
  }
}

}  // namespace fallen
