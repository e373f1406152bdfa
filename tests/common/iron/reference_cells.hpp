// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// Cells of a real depth cloud with the descriptors that the authors' implementation gave them.
struct ReferenceCells {
  std::vector<NdtCell> cells;
  std::vector<int> neighbor_counts;
  std::vector<std::array<double, 48>> descriptors;
};

/// Reads the gzip-compressed table. @throws std::runtime_error naming the line that makes no sense.
ReferenceCells ReadReferenceCells(const std::filesystem::path& path);

}  // namespace fallen
