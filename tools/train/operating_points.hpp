// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fallen/classification/calibration.hpp"
#include "fallen/evaluation/detection_error_tradeoff.hpp"

namespace fallen {

/// The working points of a validation curve that a model keeps: the most lenient threshold for each
/// of the rates a user may ask for, from 1 false positive per frame down to 0.001.
std::vector<Calibration::OperatingPoint> OperatingPointsOf(const DetectionErrorTradeoff& tradeoff);

}  // namespace fallen
