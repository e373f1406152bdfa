// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/row_evaluation.hpp"

#include <atomic>
#include <utility>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/segmentation/parallel_for.hpp"

namespace fallen {

void ObservePair(const std::filesystem::path& log, const GroundConfig& ground, const NdtConfig& ndt,
                 int stride, ObservedRecording& accumulated, ObservedRecording& single) {
  // Each kept frame comes twice: of the accumulated map, then alone.
  ObservedRecording both =
      ObserveRecording(log, ground, ndt, {.frame_stride = stride, .single_frame_stride = stride});
  accumulated.origin = single.origin = both.origin;
  for (std::size_t i = 0; i + 1 < both.frames.size(); i += 2) {
    accumulated.frames.push_back(std::move(both.frames[i]));
    single.frames.push_back(std::move(both.frames[i + 1]));
  }
}

std::vector<SequenceOutcome> JudgeRow(const AblationRow& row, const Model& model,
                                      const ObservedPairs& recordings,
                                      const Backgrounds& backgrounds, int jobs,
                                      const TrainingProgress& progress) {
  const BackgroundSubtractor nothing_known;
  const auto known = backgrounds.find(row.map);
  const std::size_t count = recordings.accumulated.size();
  std::vector<SequenceOutcome> outcomes(count);
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(count), jobs, [&](int i) {
    const ObservedRecording& accumulated = recordings.accumulated[i];
    const ObservedRecording& mapped = row.accumulate ? accumulated : recordings.single[i];
    const BackgroundSubtractor& background =
        known == backgrounds.end() ? nothing_known : known->second[i];
    SequenceOutcome& outcome = outcomes[i];
    outcome.log = accumulated.origin.log;
    outcome.person = accumulated.origin.person;
    outcome.room = accumulated.origin.room;
    for (std::size_t k = 0; k < mapped.frames.size(); ++k) {
      const SegmentedMap segmented =
          SegmentCells(background.Subtract(mapped.frames[k].map), model.cells, row.segmentation);
      outcome.frames.push_back(JudgeFrame(ClassifyClusters(segmented, model.clusters),
                                          accumulated.frames[k].person_box,
                                          accumulated.frames[k].cells_in_box));
    }
    progress("judging", static_cast<double>(++done) / static_cast<double>(count));
  });
  return outcomes;
}

}  // namespace fallen
