// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/cell_training.hpp"

#include "tools/train/gate_training.hpp"

namespace fallen {

CellModel TrainCellModel(const CellSamples& samples, double cell_size_m,
                         const TrainingConfig& config, int jobs, const TrainingProgress& progress) {
  CellModel model;
  model.cell_size_m = cell_size_m;
  model.iron = config.iron;
  model.signs = config.signs;
  model.features = config.sampling.features;
  model.trees = TrainBoostedTrees(
      samples.features, samples.labels, samples.weights, config.boosting,
      [&](const BoostingProgress& state) {
        progress("boosting", static_cast<double>(state.round) / config.boosting.rounds);
      },
      jobs);
  if (config.sampling.gate_person_share < 1)
    model.gate = TrainCellGate(samples, model.trees, config, jobs, progress);
  return model;
}

}  // namespace fallen
