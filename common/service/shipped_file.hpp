// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace fallen {

/// A file of models/ as shipped: what the environment variable `variable` names, else
/// share/fallen/models/`name` of the executable's installation, else models/`name` of the source
/// tree of a build. Where none is there, the installation's path: opening it tells.
std::filesystem::path ShippedFilePath(const std::string& name, const std::string& variable);

}  // namespace fallen
