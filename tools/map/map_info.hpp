// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace fallen {

/// What an environment map file holds, in lines of `name: value`.
/// @throws std::runtime_error as LoadEnvironmentMap.
std::string DescribeMapFile(const std::filesystem::path& file);

}  // namespace fallen
