// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "fallen/evaluation/bootstrap.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"

namespace fallen {

/// What a row made of the frames of each recording, as a JSON list a recording: enough to measure
/// the row again.
nlohmann::json OutcomesJson(const std::vector<SequenceOutcome>& sequences);

/// Miss rates of `row` minus those of `first`, rows' OutcomesJson on the same frames, with
/// intervals:
/// `{"miss_rate_at_0.01_fppf": {"difference": …, "interval": [low, high]}, …}`.
///
/// Whole recordings are drawn, each with what both rows made of it: what makes a recording hard for
/// both cancels out, so that the intervals are narrower than those of the rows.
/// @throws std::invalid_argument if the rows are not about equally many recordings and frames.
nlohmann::json DifferenceJson(const nlohmann::json& first, const nlohmann::json& row,
                              const BootstrapConfig& bootstrap);

}  // namespace fallen
