// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

#include "tools/simulate/simulation.hpp"

namespace fallen::sim {

/// Writes a simulation as an LCM log. Per frame, in this order: ROBOT_POSE, GROUND_TRUTH_<CAMERA>,
/// DEPTH_<CAMERA>, all with the picture's time.
///
/// @param jobs      Threads that take pictures; the log is the same for any number.
/// @param progress  Called with the number of frames written so far; may be empty.
/// @throws std::runtime_error if the log cannot be written.
void WriteRecording(const Simulation& simulation, const std::filesystem::path& path, int jobs,
                    const std::function<void(int)>& progress);

}  // namespace fallen::sim
