// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace fallen {

/// Path of a file that comes with the project: in share/fallen beside the installed program, else
/// in the source tree of a build. "" if it is in neither.
/// @param name  "config/60-fallen-lcm.conf"
std::string FindShippedFile(const std::string& name);

}  // namespace fallen
