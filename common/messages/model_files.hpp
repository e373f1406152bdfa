// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "fallen/detection/detector.hpp"
#include "fallen/segmentation/background_subtraction.hpp"

/// Model and environment map files: magic, version and check sum around one encoded message.
namespace fallen {

/// @throws std::runtime_error naming file, place, got and expected: not there, not such a file, of
/// another version, damaged, or with values out of range.
Model LoadModel(const std::filesystem::path& path);
EnvironmentMap LoadEnvironmentMap(const std::filesystem::path& path);

/// Writes beside the target and renames, so that a reader never sees half a file.
/// @throws std::runtime_error if that fails.
void SaveModel(const std::filesystem::path& path, const Model& model);
void SaveEnvironmentMap(const std::filesystem::path& path, const EnvironmentMap& map,
                        const std::string& description);

}  // namespace fallen
