// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace fallen {

/// True for the names of files that ReadCloud reads: .ply, .pcd.
bool IsCloudFile(const std::filesystem::path& file);

/// Finite points of a PLY or PCD file.
/// @throws std::runtime_error if it cannot be read, or has no x, y, z of float or double.
std::vector<Eigen::Vector3d> ReadCloud(const std::filesystem::path& file);

}  // namespace fallen
