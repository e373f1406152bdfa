// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tools/simulate/simulation.hpp"

namespace fallen::sim {

/// What is true of a recording and has no field in its messages, as one JSON object: `scenario` as
/// DescribeScenario tells it; `room_m`; `objects`, the categories in the scene; and, with a person:
/// `placement` (reached, which a full room may keep from being the wanted one), `sink_m` and
/// `float_m` (how well it lies), `height_m` above the floor, `visible_share` of every fifth
/// picture.
std::string DescribeRecording(const Simulation& simulation);

}  // namespace fallen::sim
