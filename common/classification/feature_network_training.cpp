// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/feature_network_training.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fallen {
namespace {

// A feature that hardly varies says nothing; dividing by its deviation would make noise of it.
constexpr float kMinDeviation = 1e-6F;

void Require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("feature_network_training: " + what);
}

void CheckSamples(const Eigen::Ref<const FeatureMatrix>& features,
                  std::span<const std::int8_t> labels, std::span<const float> weights) {
  const auto rows = static_cast<std::size_t>(features.rows());
  Require(labels.size() == rows && (weights.empty() || weights.size() == rows),
          std::to_string(rows) + " samples, " + std::to_string(labels.size()) + " labels and " +
              std::to_string(weights.size()) + " weights, must be as many");
  Require(features.cols() > 0, "samples must have features");
  Require(features.allFinite(), "a feature is not finite");
  for (const float weight : weights)
    Require(weight > 0 && std::isfinite(weight), "weights must be > 0 and finite");
  const auto persons = std::count(labels.begin(), labels.end(), 1);
  const auto others = std::count(labels.begin(), labels.end(), -1);
  Require(static_cast<std::size_t>(persons + others) == rows, "labels must be 1 or -1");
  Require(persons > 0 && others > 0, "samples of both labels must be there");
}

// Raw generator only: the library's distributions differ from one to the next.
class Random {
 public:
  explicit Random(std::int64_t seed) : generator_(static_cast<std::uint64_t>(seed)) {}

  // In [-bound, bound).
  float Uniform(float bound) {
    return bound * (static_cast<float>(generator_() >> 40) * 0x1.0p-23F - 1);
  }
  void Shuffle(std::vector<Eigen::Index>& values) {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[generator_() % i]);
  }
  // Zero with probability `dropped`, else what makes up for those.
  void FillMask(double dropped, FeatureMatrix& mask) {
    const auto limit = static_cast<std::uint64_t>(dropped * 0x1.0p16);
    const float kept = 1 / static_cast<float>(1 - static_cast<double>(limit) * 0x1.0p-16);
    std::uint64_t bits = 0;
    for (Eigen::Index i = 0; i < mask.size(); ++i, bits >>= 16) {
      if (i % 4 == 0) bits = generator_();
      mask.data()[i] = (bits & 0xffff) < limit ? 0 : kept;
    }
  }

 private:
  std::mt19937_64 generator_;
};

// A layer with its gradient, and what [Kingma15] remembers of earlier ones.
class LearningLayer {
 public:
  LearningLayer(Eigen::Index inputs, Eigen::Index outputs, Random& random) {
    layer_.weights.resize(inputs, outputs);
    const float bound = std::sqrt(6.0F / static_cast<float>(inputs));
    for (Eigen::Index i = 0; i < layer_.weights.size(); ++i)
      layer_.weights.data()[i] = random.Uniform(bound);
    layer_.bias.setZero(outputs);
    for (FeatureMatrix* moment : {&weight_mean_, &weight_square_}) moment->setZero(inputs, outputs);
    for (Eigen::RowVectorXf* moment : {&bias_mean_, &bias_square_}) moment->setZero(outputs);
  }

  const FeatureNetwork::Layer& layer() const { return layer_; }

  void Forward(const FeatureMatrix& input, FeatureMatrix& output) const {
    output.noalias() = input * layer_.weights;
    output.rowwise() += layer_.bias;
  }
  void Backward(const FeatureMatrix& delta, FeatureMatrix& input_delta) const {
    input_delta.noalias() = delta * layer_.weights.transpose();
  }
  void Step(const FeatureMatrix& input, const FeatureMatrix& delta, float decay, float rate,
            int step) {
    gradient_.noalias() = input.transpose() * delta;
    gradient_ += decay * layer_.weights;
    const float rate_now = rate * std::sqrt(1 - std::pow(kSquareKept, static_cast<float>(step))) /
                           (1 - std::pow(kMeanKept, static_cast<float>(step)));
    Descend(gradient_, weight_mean_, weight_square_, rate_now, layer_.weights);
    Descend(delta.colwise().sum().eval(), bias_mean_, bias_square_, rate_now, layer_.bias);
  }

 private:
  static constexpr float kMeanKept = 0.9F, kSquareKept = 0.999F, kEpsilon = 1e-8F;

  template <class Values>
  static void Descend(const Values& gradient, Values& mean, Values& square, float rate,
                      Values& values) {
    mean = kMeanKept * mean + (1 - kMeanKept) * gradient;
    square = kSquareKept * square + (1 - kSquareKept) * gradient.cwiseAbs2();
    values.array() -= rate * mean.array() / (square.array().sqrt() + kEpsilon);
  }

  FeatureNetwork::Layer layer_;
  FeatureMatrix gradient_, weight_mean_, weight_square_;
  Eigen::RowVectorXf bias_mean_, bias_square_;
};

// The network while it learns: a batch forward, its error back.
class Learner {
 public:
  Learner(Eigen::Index features, const NetworkTrainingConfig& config, Random& random)
      : config_(config), random_(random) {
    layers_.emplace_back(features, config.first_units, random);
    layers_.emplace_back(config.first_units, config.second_units, random);
    layers_.emplace_back(config.second_units, 1, random);
    inputs_.resize(layers_.size() + 1);
    masks_.resize(layers_.size() - 1);
  }

  FeatureMatrix& batch() { return inputs_[0]; }

  // Returns the loss before the step.
  double Learn(const Eigen::VectorXf& signs, const Eigen::VectorXf& weights, float rate) {
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      layers_[i].Forward(inputs_[i], inputs_[i + 1]);
      if (i == masks_.size()) break;
      FeatureMatrix& hidden = inputs_[i + 1];
      masks_[i].resize(hidden.rows(), hidden.cols());
      random_.FillMask(config_.dropout, masks_[i]);
      masks_[i].array() *= (hidden.array() > 0).cast<float>();
      hidden.array() *= masks_[i].array();
    }
    const Eigen::ArrayXf margin = inputs_.back().col(0).array() * signs.array();
    const Eigen::ArrayXf share = weights.array() / weights.sum();
    delta_ = (-share * signs.array() / (1 + margin.exp())).matrix();
    ++step_;
    for (std::size_t i = layers_.size(); i-- > 0;) {
      if (i > 0) layers_[i].Backward(delta_, next_delta_);
      layers_[i].Step(inputs_[i], delta_, static_cast<float>(config_.weight_decay), rate, step_);
      if (i == 0) break;
      delta_ = next_delta_.cwiseProduct(masks_[i - 1]);
    }
    // log(1 + exp(-m)) without overflow.
    return (share * ((-margin).cwiseMax(0.0F) + (1 + (-margin.abs()).exp()).log())).sum();
  }

  std::vector<FeatureNetwork::Layer> layers() const {
    std::vector<FeatureNetwork::Layer> layers;
    for (const LearningLayer& layer : layers_) layers.push_back(layer.layer());
    return layers;
  }

 private:
  const NetworkTrainingConfig& config_;
  Random& random_;
  std::vector<LearningLayer> layers_;
  std::vector<FeatureMatrix> inputs_;  // of each layer, then the output
  std::vector<FeatureMatrix> masks_;   // of each hidden layer: what passes, and how much of it
  FeatureMatrix delta_, next_delta_;
  int step_ = 0;
};

}  // namespace

void NetworkTrainingConfig::Validate() const {
  Require(epochs >= 0, "epochs must be >= 0");
  Require(first_units >= 1 && second_units >= 1, "first_units and second_units must be >= 1");
  Require(batch_size >= 1, "batch_size must be >= 1");
  Require(learning_rate > 0 && std::isfinite(learning_rate), "learning_rate must be > 0");
  Require(dropout >= 0 && dropout < 1, "dropout must be in [0, 1)");
  Require(weight_decay >= 0 && std::isfinite(weight_decay), "weight_decay must be >= 0");
}

FeatureNetwork TrainFeatureNetwork(
    const Eigen::Ref<const FeatureMatrix>& features, std::span<const std::int8_t> labels,
    std::span<const float> weights, const NetworkTrainingConfig& config,
    const std::function<void(const NetworkTrainingProgress&)>& progress) {
  config.Validate();
  if (config.epochs == 0) return {};
  CheckSamples(features, labels, weights);
  FeatureNetwork network;
  network.mean = features.cast<double>().colwise().mean().cast<float>();
  network.scale = (features.rowwise() - network.mean)
                      .cwiseAbs2()
                      .cast<double>()
                      .colwise()
                      .mean()
                      .cast<float>()
                      .cwiseSqrt()
                      .unaryExpr([](float deviation) {
                        return deviation > kMinDeviation ? 1 / deviation : 0.0F;
                      });

  Random random(config.seed);
  Learner learner(features.cols(), config, random);
  const Eigen::Index batch = std::min<Eigen::Index>(config.batch_size, features.rows());
  const Eigen::Index batches = features.rows() / batch;
  const double steps = static_cast<double>(batches) * config.epochs;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(features.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  Eigen::VectorXf signs(batch), batch_weights = Eigen::VectorXf::Ones(batch);
  NetworkTrainingProgress state;
  double step = 0;
  for (int epoch = 0; epoch < config.epochs; ++epoch) {
    random.Shuffle(order);
    for (Eigen::Index first = 0; first + batch <= features.rows(); first += batch) {
      learner.batch().resize(batch, features.cols());
      for (Eigen::Index i = 0; i < batch; ++i) {
        const Eigen::Index sample = order[static_cast<std::size_t>(first + i)];
        learner.batch().row(i) = network.Standardize(features.row(sample));
        signs[i] = labels[static_cast<std::size_t>(sample)];
        if (!weights.empty()) batch_weights[i] = weights[static_cast<std::size_t>(sample)];
      }
      const double rate =
          config.learning_rate * (1 + std::cos(std::numbers::pi * step / steps)) / 2;
      state.loss = learner.Learn(signs, batch_weights, static_cast<float>(rate));
      state.done = ++step / steps;
      if (progress) progress(state);
    }
  }
  network.layers = learner.layers();
  return network;
}

}  // namespace fallen
