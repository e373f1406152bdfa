// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "bench_sequence.hpp"
#include "tools/common/detector_setup.hpp"

namespace fallen {

/// Registers Detect, the stages Ground*, Ndt and Iron, on `sequence`, at the configuration of
/// `options`. Without a model Detect is skipped and says so, unless `options` names one.
/// @throws std::runtime_error if a file that `options` names is missing, damaged or does not fit.
void RegisterStageBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                             const DetectorOptions& options);

/// Registers what PCL offers for comparison on the clouds of the same frames: PclVoxelGrid,
/// PclVoxelGridCovariance (its NDT) and PclSacSegmentation. The clouds are made beforehand.
void RegisterPclBenchmarks(const std::shared_ptr<BenchSequence>& sequence);

}  // namespace fallen
