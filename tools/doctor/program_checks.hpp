// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/doctor/finding.hpp"

namespace fallen {

/// Programs and Java archives that recording, replaying and looking on take.
///
/// @param search_path  As in $PATH.
/// @param java_folder  Where Java archives are installed.
std::vector<Finding> CheckPrograms(const std::string& search_path,
                                   const std::string& java_folder = "/usr/share/java");

}  // namespace fallen
