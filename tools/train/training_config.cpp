// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/training_config.hpp"

#include <stdexcept>
#include <string>

#include "tools/train/settings_file.hpp"

namespace fallen {
namespace {

void Require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace

void TrainingConfig::Validate() const {
  Require(observation.frame_stride >= 1, "observation: frame_stride must be >= 1");
  Require(observation.single_frame_stride >= 0, "observation: single_frame_stride must be >= 0");
  Require(sampling.gate_person_share > 0 && sampling.gate_person_share <= 1,
          "sampling: gate_person_share must be in (0, 1]");
  Require(sampling.gate_person_share == 1 || sampling.features == CellFeatureSet::kIronAndShape,
          "sampling: gate_person_share must be 1 where features is iron: the gate looks at shape");
  Require(sampling.max_person_cells > 0, "sampling: max_person_cells must be > 0");
  Require(sampling.max_other_cells > 0, "sampling: max_other_cells must be > 0");
  Require(sampling.codebook_cells >= codebook.max_units,
          "sampling: codebook_cells must be >= codebook.max_units");
  Require(sampling.alpha >= 0 && sampling.alpha < 1, "sampling: alpha must be in [0, 1)");
  Require(sampling.min_person_share > 0 && sampling.min_person_share <= 1,
          "sampling: min_person_share must be in (0, 1]");
  Require(sampling.network_share >= 0 && sampling.network_share <= 1,
          "sampling: network_share must be in [0, 1]");
  gate_boosting.Validate();
  boosting.Validate();
  cluster_boosting.Validate();
  cluster_network.Validate();
  segmentation.Validate();
  codebook.Validate();
  iron.Validate();
}

TrainingConfig LoadTrainingConfig(const std::optional<std::filesystem::path>& path) {
  return LoadSettings<TrainingConfig>(path);
}

}  // namespace fallen
