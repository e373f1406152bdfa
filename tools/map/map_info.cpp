// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/map_info.hpp"

#include <Eigen/Geometry>
#include <cstdint>
#include <iomanip>
#include <sstream>

#include "fallen/messages/model_files.hpp"

namespace fallen {

std::string DescribeMapFile(const std::filesystem::path& file) {
  const EnvironmentMap map = LoadEnvironmentMap(file);
  Eigen::AlignedBox3f extent;
  std::uint64_t points = 0;
  for (const NdtCell& cell : map.cells) {
    extent.extend(cell.mean);
    points += cell.point_count;
  }
  std::ostringstream text;
  text << "description: " << map.description << '\n'
       << "cells: " << map.cells.size() << '\n'
       << "points: " << points << '\n'
       << "cell_size_m: " << map.cell_size_m << '\n';
  if (!extent.isEmpty()) {
    text << std::fixed << std::setprecision(2);
    for (int axis = 0; axis < 3; ++axis)
      text << "xyz"[axis] << "_m: " << extent.min()[axis] << " to " << extent.max()[axis] << '\n';
  }
  text << "bytes: " << std::filesystem::file_size(file) << '\n';
  return text.str();
}

}  // namespace fallen
