// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "bench_sequence.hpp"
#include "tools/common/detector_setup.hpp"

namespace fallen {

/// Registers Detect, DetectAccumulating, DetectAsConfigured, the stages Ground*, Ndt and Iron, on
/// `sequence`, at the configuration of `options`. Without a model the first three are skipped and
/// say so, unless `options` names one.
///
/// Detect knows the mounting and makes a fresh map of every frame; DetectAccumulating adds
/// accumulation, occupancy and background subtraction against what the first frame saw.
/// @throws std::runtime_error if a file that `options` names is missing, damaged or does not fit.
void RegisterStageBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                             const DetectorOptions& options);

/// Registers the plain ways of the kernels beside them: IronKdTree (FLANN's radius search and
/// arccosines, beside Iron), BoostedTrees and PlainTreeWalker (one row and one node after the
/// other) on the features of all described cells. The trees are skipped without a model.
void RegisterPeerBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                            const DetectorOptions& options);

/// Registers what PCL offers for comparison on the clouds of the same frames: PclVoxelGrid,
/// PclVoxelGridCovariance (its NDT) and PclSacSegmentation. The clouds are made beforehand.
void RegisterPclBenchmarks(const std::shared_ptr<BenchSequence>& sequence);

/// Registers Baseline, the comparison detector on the same frames with the mounting known, and its
/// steps beside ours: PclNormalEstimation of the baseline's thinned cloud beside CellNormals of the
/// frame's cells, PclEuclideanClusters beside Dbscan, both on the cells' means. The first is
/// skipped without a baseline model.
void RegisterBaselineBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                                const DetectorOptions& options);

/// Registers CellsToDecision/n: all stages after the mapping on maps of 500 to 8000 cells, with the
/// pairs of cells that descriptors compare. Skipped without a model.
void RegisterCostBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                            const DetectorOptions& options);

/// Registers MapSearch/n, FlannMapSearch/n and MapLoad/n on environment maps of 10^3 to 10^6 cells:
/// background subtraction of a frame, FLANN's nearest neighbours of the same cells, and reading the
/// file until the first frame can come.
void RegisterEnvironmentBenchmarks(const std::shared_ptr<BenchSequence>& sequence);

/// Registers Encode/TYPE, Transfer/TYPE and Decode/TYPE for each message that travels: from the
/// value to bytes, through LCM on the loopback, from bytes to the value, on what the services would
/// send about the frames at the configuration of `options`. Alarms, answers and statuses are made
/// up. Transfer is skipped where LCM cannot be opened, all without a model.
void RegisterTransportBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                                 const DetectorOptions& options);

}  // namespace fallen
