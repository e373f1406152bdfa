// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fallen/evaluation/frame_outcome.hpp"
#include "tools/evaluate/error_cases.hpp"
#include "tools/evaluate/evaluated_method.hpp"

namespace fallen {

/// What a method made of one recording.
struct SequenceOutcome {
  std::string log;
  std::string person;
  std::string room;
  /// What is in the scene besides furniture and the fallen person ("dog", "person", ...), sorted.
  std::vector<std::string> kinds;
  std::vector<FrameOutcome> frames;
  std::vector<std::int64_t> frame_numbers;  ///< place of each of `frames` in the recording, from 0
  /// Frames with a person somewhere, but no pose that would say where: judged neither way.
  std::int64_t unjudged_frames = 0;
  std::int64_t damaged_messages = 0;
  double median_milliseconds = 0;
  double min_probability = 0;    ///< threshold in force
  std::vector<ErrorCase> cases;  ///< all persons and all that is taken for one
};

/// Runs `method`, a fresh one, over a log or import directory and judges every frame by its ground
/// truth. @throws std::runtime_error if the input cannot be read or holds no ground truth.
SequenceOutcome EvaluateSequence(const std::filesystem::path& input, EvaluatedMethod& method);

}  // namespace fallen
