// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fallen/service/configuration.hpp"
#include "tools/doctor/finding.hpp"

/// Whether the files that services load can be loaded.
namespace fallen {

/// A configuration file, or why it is none.
struct CheckedConfiguration {
  Configuration configuration;  ///< the defaults if the file is no good
  Finding finding;
};
CheckedConfiguration CheckConfiguration(const std::optional<std::string>& file);

/// The model and the environment map, loaded as the services do.
std::vector<Finding> CheckFiles(const Configuration& configuration);

}  // namespace fallen
