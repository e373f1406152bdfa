// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/sequence_evaluation.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/frames/frame_source.hpp"

namespace fallen {
namespace {

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Adds what is new in `truth` to the sorted `kinds`.
void AddKinds(const GroundTruth& truth, std::vector<std::string>& kinds) {
  for (const LabelledObject& object : truth.objects) {
    if (object.category == "furniture" || object.category == "fallen_person") continue;
    const auto place = std::lower_bound(kinds.begin(), kinds.end(), object.category);
    if (place == kinds.end() || *place != object.category) kinds.insert(place, object.category);
  }
}

}  // namespace

SequenceOutcome EvaluateSequence(const std::filesystem::path& input, EvaluatedMethod& method) {
  SequenceOutcome sequence;
  sequence.log = input.string();
  CaseCollector cases(sequence.log);
  std::vector<double> milliseconds;
  bool has_truth = false;
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(input);
  for (std::int64_t number = 0; const std::optional<Frame> frame = recording->Next(); ++number) {
    const MethodFrame result = method.Detect(*frame);
    milliseconds.push_back(result.milliseconds);
    sequence.min_probability = result.decision.min_probability;
    const std::optional<GroundTruth> truth = recording->Truth(*frame);
    if (!truth) continue;
    has_truth = true;
    if (!truth->person.empty()) sequence.person = truth->person;
    if (!truth->room.empty()) sequence.room = truth->room;
    AddKinds(*truth, sequence.kinds);
    if (truth->person_box && result.decision.frame != MapFrame::kWorld) {
      ++sequence.unjudged_frames;
      continue;
    }
    const int cells = truth->person_box ? CountCellsInBox(result.local_map, *truth->person_box) : 0;
    sequence.frame_numbers.push_back(number);
    sequence.frames.push_back(JudgeFrame(result.decision, truth->person_box, cells));
    cases.Add(number, result.decision, *truth, cells);
  }
  if (!has_truth)
    throw std::runtime_error(input.string() +
                             ": no ground truth for any frame, expected GROUND_TRUTH_* messages");
  sequence.cases = cases.cases();
  sequence.damaged_messages = recording->damage().count;
  sequence.median_milliseconds = Median(std::move(milliseconds));
  return sequence;
}

}  // namespace fallen
