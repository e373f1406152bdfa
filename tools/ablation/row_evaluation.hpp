// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fallen/detection/model.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "tools/ablation/ablation_rows.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"
#include "tools/train/observation.hpp"
#include "tools/train/training_progress.hpp"

namespace fallen {

/// Recordings to judge on, mapped in both ways: the same frames with and without accumulation.
struct ObservedPairs {
  std::vector<ObservedRecording> accumulated;
  std::vector<ObservedRecording> single;
};

/// Maps every `stride`-th frame of a recording both ways. @throws as ObserveRecording.
void ObservePair(const std::filesystem::path& log, const GroundConfig& ground, const NdtConfig& ndt,
                 int stride, ObservedRecording& accumulated, ObservedRecording& single);

/// Background subtractors of the recordings, for each age of the maps that a row wants.
using Backgrounds = std::map<MapAge, std::vector<BackgroundSubtractor>>;

/// Judges all recordings by a row's variant of the method.
///
/// Whether a person counts as present (the paper, Sec. IV-B) is always asked of the accumulated
/// map, so that all rows are about the same persons.
/// @param model  The row's own, or the first row's.
std::vector<SequenceOutcome> JudgeRow(const AblationRow& row, const Model& model,
                                      const ObservedPairs& recordings,
                                      const Backgrounds& backgrounds, int jobs,
                                      const TrainingProgress& progress);

}  // namespace fallen
