// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/scene/cell_ages.hpp"

#include <cmath>

namespace fallen {

std::size_t CellAges::Hash::operator()(const Voxel& voxel) const {
  // [Teschner03] Optimized spatial hashing for collision detection of deformable objects.
  const auto part = [](std::int32_t value, std::size_t prime) {
    return static_cast<std::size_t>(static_cast<std::uint32_t>(value)) * prime;
  };
  return part(voxel[0], 73856093) ^ part(voxel[1], 19349663) ^ part(voxel[2], 83492791);
}

std::vector<double> CellAges::Update(std::int64_t utime, double cell_size_m,
                                     std::span<const NdtCell> cells) {
  if (utime < newest_utime_) seen_.clear();
  newest_utime_ = utime;
  std::unordered_map<Voxel, Seen, Hash> now;
  now.reserve(cells.size());
  std::vector<double> ages;
  ages.reserve(cells.size());
  for (const NdtCell& cell : cells) {
    const auto index = [&](int axis) {
      return static_cast<std::int32_t>(std::floor(cell.mean[axis] / cell_size_m));
    };
    const Voxel voxel{index(0), index(1), index(2)};
    const auto known = seen_.find(voxel);
    const bool is_unchanged = known != seen_.end() && known->second.cell.mean == cell.mean &&
                              known->second.cell.point_count == cell.point_count;
    const std::int64_t changed = is_unchanged ? known->second.utime : utime;
    now[voxel] = {cell, changed};
    ages.push_back(static_cast<double>(utime - changed) * 1e-6);
  }
  seen_ = std::move(now);
  return ages;
}

}  // namespace fallen
