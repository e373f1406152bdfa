// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// How long ago each cell of a growing map last took points in: what is seen now has age 0, what is
/// remembered grows old. Not thread-safe.
class CellAges {
 public:
  /// Ages [s] of `cells`, in their order, at `utime`. A cell is new where its place or its number
  /// of points is. Time that runs backwards starts anew.
  std::vector<double> Update(std::int64_t utime, double cell_size_m,
                             std::span<const NdtCell> cells);

 private:
  using Voxel = std::array<std::int32_t, 3>;
  struct Hash {
    std::size_t operator()(const Voxel& voxel) const;
  };
  struct Seen {
    NdtCell cell;
    std::int64_t utime = 0;
  };
  std::unordered_map<Voxel, Seen, Hash> seen_;
  std::int64_t newest_utime_ = 0;
};

}  // namespace fallen
