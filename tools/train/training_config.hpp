// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "fallen/classification/feature_network_training.hpp"
#include "fallen/classification/growing_neural_gas.hpp"
#include "fallen/geometry/enum_names.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"
#include "tools/train/observation.hpp"

namespace fallen {

/// What decides about a cluster.
enum class ClusterScore : std::int32_t {
  kMahalanobis = 0,  ///< the distance of its code alone: the paper
  kBoosted = 1,      ///< boosted trees, and a network, on code, distance, size, height, outline and
                     ///< surroundings
};
constexpr auto EnumNames(ClusterScore) {
  return EnumTable<ClusterScore, 2>{
      {{ClusterScore::kMahalanobis, "mahalanobis"}, {ClusterScore::kBoosted, "boosted"}}};
}

/// Where the cells of fallen persons are taken from.
enum class PositiveCells : std::int32_t {
  kInScene = 0,   ///< from the scene, with what stands around in their descriptors
  kIsolated = 1,  ///< free from ground and other objects, others from person-free frames: the paper
};
constexpr auto EnumNames(PositiveCells) {
  return EnumTable<PositiveCells, 2>{
      {{PositiveCells::kInScene, "in_scene"}, {PositiveCells::kIsolated, "isolated"}}};
}

/// Which cells and clusters are learnt from.
struct SamplingConfig {
  CellFeatureSet features = CellFeatureSet::kIronAndShape;
  PositiveCells positives = PositiveCells::kInScene;
  /// The gate lets so many of the persons' cells pass, (0, 1]; 1: there is no gate, as in the
  /// paper.
  double gate_person_share = 0.9995;
  int max_person_cells = 400000;  ///< drawn from all frames alike
  int max_other_cells = 800000;
  int codebook_cells = 100000;  ///< descriptors shown to the codebook
  double alpha = 0.7;           ///< soft threshold on the cosine
  /// A cluster is a fallen person's if so many of its labelled cells are, (0, 1].
  double min_person_share = 0.5;
  ClusterScore cluster_score = ClusterScore::kBoosted;
  /// Of the evidence is the network's, [0, 1]; its scores are spread ten times as far as the
  /// trees'.
  double network_share = 0.07;
  std::int64_t seed = 1;

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("features", features);
    visit("positives", positives);
    visit("gate_person_share", gate_person_share);
    visit("max_person_cells", max_person_cells);
    visit("max_other_cells", max_other_cells);
    visit("codebook_cells", codebook_cells);
    visit("alpha", alpha);
    visit("min_person_share", min_person_share);
    visit("cluster_score", cluster_score);
    visit("network_share", network_share);
    visit("seed", seed);
  }
};

/// All settings of a training, the sections of models/training.yaml.
struct TrainingConfig {
  ObservationConfig observation;
  SamplingConfig sampling;
  BoostingConfig gate_boosting{.rounds = 16, .max_depth = 4, .min_leaf_weight = 1e-3};
  BoostingConfig boosting;
  BoostingConfig cluster_boosting{
      .rounds = 300, .max_depth = 3, .min_leaf_weight = 1e-3, .learning_rate = 0.1};
  NetworkTrainingConfig cluster_network;
  SegmentationConfig segmentation;
  GrowingNeuralGasConfig codebook;
  IronConfig iron;
  /// Not a setting of files, for model files cannot say it: tools/ablation sets it.
  NormalSigns signs = NormalSigns::kArbitrary;

  /// @throws std::invalid_argument for the first setting that is out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("observation", observation);
    visit("sampling", sampling);
    visit("gate_boosting", gate_boosting);
    visit("boosting", boosting);
    visit("cluster_boosting", cluster_boosting);
    visit("cluster_network", cluster_network);
    visit("segmentation", segmentation);
    visit("codebook", codebook);
    visit("iron", iron);
  }
};

/// @throws std::runtime_error naming file, line, got and expected. No file: the defaults.
TrainingConfig LoadTrainingConfig(const std::optional<std::filesystem::path>& path);

}  // namespace fallen
