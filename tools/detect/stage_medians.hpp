// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "fallen/detection/frame.hpp"

namespace fallen {

/// Median of each stage over the frames; zeros for none. The medians do not add up to the total's.
StageTimes MedianTimes(const std::vector<StageTimes>& frames);

/// "ground 1.2 ndt 3.4 background 0.0 iron 2.1 cells 0.5 clusters 0.1 total 7.4".
std::string DescribeTimes(const StageTimes& times);

}  // namespace fallen
