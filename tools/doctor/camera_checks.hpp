// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/doctor/finding.hpp"

namespace fallen {

/// OpenNI2 and the depth cameras that it sees. Nothing here is essential: recordings do without.
/// @param device_uri  The camera that is configured; empty: any.
std::vector<Finding> CheckCameras(const std::string& device_uri);

}  // namespace fallen
