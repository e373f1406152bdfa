// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/segmentation/cell_gate.hpp"
#include "tools/train/cell_samples.hpp"

namespace fallen {

/// Trains the gate before `trees`, and sets its threshold so that
/// `config.sampling.gate_person_share` of the persons' cells pass.
/// @param samples  Of CellFeatureSet::kIronAndShape.
/// @param trees    Trained on all of them; the gate speaks for them where it turns cells away.
CellGate TrainCellGate(const CellSamples& samples, const BoostedTrees& trees,
                       const TrainingConfig& config, int jobs, const TrainingProgress& progress);

/// What a gate lets pass.
struct GateFigures {
  double person_share = 1;  ///< of the persons' cells, [0, 1]
  double other_share = 1;   ///< of the others
};
GateFigures MeasureGate(const CellGate& gate, const CellSamples& samples);

}  // namespace fallen
