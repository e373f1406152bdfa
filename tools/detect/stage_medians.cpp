// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/stage_medians.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace fallen {
namespace {

constexpr std::array<std::pair<const char*, double StageTimes::*>, 7> kStages = {{
    {"ground", &StageTimes::ground},
    {"ndt", &StageTimes::ndt},
    {"background", &StageTimes::background},
    {"iron", &StageTimes::iron},
    {"cells", &StageTimes::cells},
    {"clusters", &StageTimes::clusters},
    {"total", &StageTimes::total},
}};

}  // namespace

StageTimes MedianTimes(const std::vector<StageTimes>& frames) {
  StageTimes medians;
  if (frames.empty()) return medians;
  std::vector<double> values(frames.size());
  for (const auto& [name, stage] : kStages) {
    std::transform(frames.begin(), frames.end(), values.begin(),
                   [stage = stage](const StageTimes& times) { return times.*stage; });
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    medians.*stage = *middle;
  }
  return medians;
}

std::string DescribeTimes(const StageTimes& times) {
  std::string text;
  for (const auto& [name, stage] : kStages) {
    char part[64];
    std::snprintf(part, sizeof part, "%s%s %.1f", text.empty() ? "" : " ", name, times.*stage);
    text += part;
  }
  return text;
}

}  // namespace fallen
