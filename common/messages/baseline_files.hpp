// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "fallen/baseline/baseline_model.hpp"
#include "fallen/baseline_model_t.hpp"

/// Files of the comparison detector's models; magic, version and check sum as in model files.
namespace fallen {

/// Message <-> domain value, without loss; see conversions.hpp.
/// @throws std::invalid_argument naming field, got and expected.
baseline_model_t ToMessage(const BaselineModel& model);
BaselineModel FromMessage(const baseline_model_t& message);

/// @throws std::runtime_error naming file, place, got and expected: not there, not such a file, of
/// another version, damaged, or with values out of range.
BaselineModel LoadBaselineModel(const std::filesystem::path& path);

/// Writes beside the target and renames. @throws std::runtime_error if that fails.
void SaveBaselineModel(const std::filesystem::path& path, const BaselineModel& model);

}  // namespace fallen
