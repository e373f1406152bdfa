// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_alarm/drive_trace.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include "fallen/evaluation/frame_outcome.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {

DriveTrace TraceDrive(const std::filesystem::path& input, Detector detector) {
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(input);
  DriveTrace trace;
  trace.log = input.string();
  trace.camera = recording->camera();
  while (const std::optional<Frame> frame = recording->Next()) {
    FrameResult result = detector.Detect(*frame);
    const std::optional<GroundTruth> truth = recording->Truth(*frame);
    if (!truth) continue;
    TracedFrame traced{frame->utime, std::move(result.decision), truth->person_box};
    traced.is_in_view =
        truth->person_box && traced.decision.frame == MapFrame::kWorld &&
        CountCellsInBox(result.foreground.map, *truth->person_box) >= kMinCellsInBox;
    trace.frames.push_back(std::move(traced));
  }
  if (trace.frames.empty())
    throw std::runtime_error(trace.log +
                             ": no ground truth for any frame, expected GROUND_TRUTH_* messages");
  return trace;
}

}  // namespace fallen
