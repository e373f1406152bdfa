// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/frame_choice.hpp"

#include <charconv>
#include <stdexcept>
#include <utility>

#include "tools/common/progress_bar.hpp"

namespace fallen {
namespace {

/// Probability of the best cluster; below every probability if there is none.
double Rating(const FrameResult& result) {
  const auto& hypotheses = result.decision.hypotheses;
  return hypotheses.empty() ? -1 : hypotheses.front().probability;
}

}  // namespace

FrameChoice ParseFrameChoice(const std::string& text) {
  if (text == "best") return {};
  std::int64_t index = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size() || index < 0)
    throw std::invalid_argument("got \"" + text + "\", expected a frame number or \"best\"");
  return {index};
}

ViewedFrame FindFrame(FrameSource& recording, Detector& detector, const FrameChoice& choice,
                      const std::string& name) {
  std::optional<ViewedFrame> chosen;
  std::int64_t index = 0;
  ProgressBar progress("view");
  for (; std::optional<Frame> frame = recording.Next(); ++index) {
    progress.Update(recording.share_done(), "frame " + std::to_string(index));
    FrameResult result;
    try {
      result = detector.Detect(*frame);
    } catch (const std::invalid_argument&) {
      continue;  // nothing to be seen in an image that is none
    }
    const bool is_wanted =
        choice.index ? index == *choice.index : !chosen || Rating(result) > Rating(chosen->result);
    if (is_wanted) chosen = ViewedFrame{name, index, std::move(*frame), std::move(result), {}};
    if (choice.index == index) break;
  }
  if (!chosen)
    throw std::runtime_error(name + ": got " + std::to_string(index) + " frames, expected " +
                             (choice.index ? "frame " + std::to_string(*choice.index)
                                           : std::string("at least one that can be used")));
  if (const std::optional<GroundTruth> truth = recording.Truth(chosen->frame))
    chosen->truth = truth->person_box;
  return std::move(*chosen);
}

}  // namespace fallen
