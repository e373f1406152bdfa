// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/alarm/alarm_fusion.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/service/configuration.hpp"

/// The files of a configuration, loaded and checked against it.
namespace fallen {

/// Loads the model that `flag` names, else the configuration's, else the shipped one.
/// @throws std::runtime_error naming the file: not to be loaded, or made for another cell size.
Model LoadModelFor(const Configuration& configuration, const std::string& flag = {});

/// The background subtractor with the environment map that `flag` names, else the configuration's,
/// else without one.
/// @throws std::runtime_error naming the file: not to be loaded, or made for another cell size.
BackgroundSubtractor LoadBackgroundFor(const Configuration& configuration,
                                       const std::string& flag = {});

/// Robot, zones and kind of cameras of a configuration.
/// @throws std::runtime_error naming the file of zones and the line: not to be read, or no polygon.
AlarmScope LoadAlarmScopeFor(const Configuration& configuration);

}  // namespace fallen
