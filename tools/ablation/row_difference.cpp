// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/row_difference.hpp"

#include <stdexcept>
#include <string>

#include "fallen/evaluation/detection_error_tradeoff.hpp"

namespace fallen {
namespace {

// A frame is [is positive, score of the hit or null, scores of false hypotheses].
nlohmann::json FrameJson(const FrameOutcome& frame) {
  return {frame.is_positive,
          frame.hit_score ? nlohmann::json(*frame.hit_score) : nlohmann::json(nullptr),
          frame.false_scores};
}

FrameOutcome FrameFromJson(const nlohmann::json& json) {
  FrameOutcome frame;
  frame.is_positive = json.at(0).get<bool>();
  if (!json.at(1).is_null()) frame.hit_score = json.at(1).get<double>();
  frame.false_scores = json.at(2).get<std::vector<double>>();
  return frame;
}

// Each recording's frames, those of the first row at even places, each followed by the row's.
std::vector<std::vector<FrameOutcome>> Interleaved(const nlohmann::json& first,
                                                   const nlohmann::json& row) {
  const auto require_equal = [](const char* what, std::size_t got, std::size_t expected) {
    if (got != expected)
      throw std::invalid_argument("ablation: got " + std::to_string(got) + " " + what +
                                  ", expected those of the first row, " + std::to_string(expected));
  };
  require_equal("recordings", row.size(), first.size());
  std::vector<std::vector<FrameOutcome>> recordings(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    require_equal("frames", row[i].size(), first[i].size());
    for (std::size_t k = 0; k < first[i].size(); ++k)
      for (const nlohmann::json* const outcomes : {&first, &row})
        recordings[i].push_back(FrameFromJson((*outcomes)[i][k]));
  }
  return recordings;
}

std::vector<double> RatesOf(const std::vector<FrameOutcome>& frames) {
  const DetectionErrorTradeoff curve = ComputeTradeoff(frames);
  return {curve.MissRateAt(0.01), curve.MissRateAt(0.1), curve.LogAverageMissRate()};
}

std::vector<double> Differences(std::span<const FrameOutcome> interleaved) {
  std::vector<FrameOutcome> first, row;
  for (std::size_t k = 0; k < interleaved.size(); ++k)
    (k % 2 == 0 ? first : row).push_back(interleaved[k]);
  std::vector<double> differences = RatesOf(row);
  const std::vector<double> from = RatesOf(first);
  for (std::size_t k = 0; k < from.size(); ++k) differences[k] -= from[k];
  return differences;
}

}  // namespace

nlohmann::json OutcomesJson(const std::vector<SequenceOutcome>& sequences) {
  nlohmann::json recordings = nlohmann::json::array();
  for (const SequenceOutcome& sequence : sequences) {
    nlohmann::json frames = nlohmann::json::array();
    for (const FrameOutcome& frame : sequence.frames) frames.push_back(FrameJson(frame));
    recordings.push_back(std::move(frames));
  }
  return recordings;
}

nlohmann::json DifferenceJson(const nlohmann::json& first, const nlohmann::json& row,
                              const BootstrapConfig& bootstrap) {
  const auto recordings = Interleaved(first, row);
  std::vector<FrameOutcome> all;
  for (const auto& frames : recordings) all.insert(all.end(), frames.begin(), frames.end());
  const std::vector<double> differences = Differences(all);
  const std::vector<Interval> intervals = BootstrapIntervals(recordings, Differences, bootstrap);
  const auto figure = [&](int k) {
    return nlohmann::json{{"difference", differences[k]},
                          {"interval", {intervals[k].low, intervals[k].high}}};
  };
  return {{"miss_rate_at_0.01_fppf", figure(0)},
          {"miss_rate_at_0.1_fppf", figure(1)},
          {"log_average_miss_rate", figure(2)}};
}

}  // namespace fallen
