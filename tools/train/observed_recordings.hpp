// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <utility>
#include <vector>

#include "fallen/segmentation/parallel_for.hpp"
#include "tools/train/recording_split.hpp"
#include "tools/train/training_progress.hpp"

/// What all trainings do with their recordings. `Recording` has a member `origin`.
namespace fallen {

/// `observe(log)` of each log, in order.
template <class Observe>
auto ObserveRecordings(const std::vector<std::filesystem::path>& logs, int jobs,
                       const TrainingProgress& progress, const Observe& observe) {
  std::vector<decltype(observe(logs[0]))> recordings(logs.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(logs.size()), jobs, [&](int i) {
    recordings[i] = observe(logs[i]);
    progress("recordings", static_cast<double>(++done) / static_cast<double>(logs.size()));
  });
  return recordings;
}

template <class Recording>
std::vector<RecordingOrigin> OriginsOf(const std::vector<Recording>& recordings) {
  std::vector<RecordingOrigin> origins;
  for (const Recording& recording : recordings) origins.push_back(recording.origin);
  return origins;
}

/// Moves the recordings of the validation side out of `recordings`, see SplitByPersonAndRoom.
template <class Recording>
std::vector<Recording> SplitOffValidation(std::vector<Recording>& recordings, double share,
                                          std::int64_t seed) {
  const RecordingSplit split =
      SplitByPersonAndRoom(OriginsOf(recordings), share, static_cast<std::uint64_t>(seed));
  std::vector<Recording> training, validation;
  for (const std::size_t i : split.training) training.push_back(std::move(recordings[i]));
  for (const std::size_t i : split.validation) validation.push_back(std::move(recordings[i]));
  recordings = std::move(training);
  return validation;
}

}  // namespace fallen
