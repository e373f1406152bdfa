// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/baseline_observation.hpp"

#include <stdexcept>
#include <utility>

#include "fallen/detection/map_update.hpp"
#include "fallen/evaluation/frame_outcome.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

BaselineRecording ObserveForBaseline(const std::filesystem::path& log,
                                     const BaselineObservation& observation) {
  BaselineRecording observed;
  observed.origin.log = log.string();
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(log);
  NdtMapper mapper(observation.ndt);
  std::int64_t number = 0;
  for (; const std::optional<Frame> frame = recording->Next(); ++number) {
    NdtMap map;
    if (observation.counts_cells) map = UpdateMap(mapper, *frame, observation.ground);
    if (number % observation.frame_stride != 0) continue;
    const std::optional<GroundTruth> truth = recording->Truth(*frame);
    if (!truth) continue;
    if (!truth->person.empty()) observed.origin.person = truth->person;
    if (!truth->room.empty()) observed.origin.room = truth->room;
    BaselineFrame kept;
    kept.clusters = DescribeClusters(*frame, observation.ground, observation.baseline);
    if (truth->person_box && kept.clusters.frame == MapFrame::kLevel) continue;
    kept.person_box = truth->person_box;
    if (truth->person_box) kept.cells_in_box = CountCellsInBox(map, *truth->person_box);
    observed.frames.push_back(std::move(kept));
  }
  if (observed.frames.empty())
    throw std::runtime_error(log.string() +
                             ": no ground truth for any frame, expected GROUND_TRUTH_* messages");
  observed.damaged = recording->damage().count;
  return observed;
}

}  // namespace fallen
