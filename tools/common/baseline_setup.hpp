// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/baseline/baseline_detector.hpp"
#include "tools/common/detector_setup.hpp"

namespace fallen {

/// Makes the comparison detector under the ground and classification settings of the detector that
/// it is compared with.
/// @param model  File; empty: the shipped baseline.model.
/// @throws std::runtime_error naming the file that is missing, damaged or does not fit.
BaselineDetector MakeBaselineDetector(const std::string& model, const DetectorOptions& options);

}  // namespace fallen
