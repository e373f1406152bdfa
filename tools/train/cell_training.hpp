// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/train/cell_samples.hpp"

namespace fallen {

/// The cell classifier (the paper, Sec. III-D.2), and the gate before it.
CellModel TrainCellModel(const CellSamples& samples, double cell_size_m,
                         const TrainingConfig& config, int jobs, const TrainingProgress& progress);

}  // namespace fallen
