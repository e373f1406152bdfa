// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "fallen/alarm/zone.hpp"

namespace fallen {

/// Reads zones: `zones:` with a list of `name`, `kind` (never, bed), `corners` ([x, y] in the
/// world) and, for a bed, `bed_height_m`.
/// @throws std::runtime_error "<file>:<line>: zones[0].kind: got ..., expected ...", also for a
/// polygon that crosses itself and for a name that comes twice.
std::vector<Zone> LoadZones(const std::filesystem::path& path);

}  // namespace fallen
