// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fallen/ndt/voxel_statistics.hpp"

namespace fallen {

/// Place of a voxel in the map's grid: it spans [index, index + 1) cell sizes along each axis.
struct VoxelIndex {
  std::int32_t x = 0, y = 0, z = 0;
  bool operator==(const VoxelIndex&) const = default;
};

/// What the map knows about one voxel.
struct Voxel {
  VoxelIndex index;
  Moments moments;             ///< of all frames before this one
  PointSums<double> incoming;  ///< of this frame, not yet merged
  double log_odds = 0;
  /// Holds points of frames in which no floor was known, so perhaps the floor's.
  bool may_hold_floor = false;
};

/// The voxels in the order in which they were first met, found by index through a hash table.
class VoxelStore {
 public:
  VoxelStore();

  /// The voxel at `index`, made if need be. The reference holds until the next call.
  Voxel& FindOrAdd(const VoxelIndex& index);

  /// Position in `voxels()` of the voxel at `index`, made if need be. `guess` is looked at first:
  /// any number, best the position of a voxel that was met nearby.
  std::int32_t FindOrAdd(const VoxelIndex& index, std::int32_t guess) {
    if (static_cast<std::size_t>(guess) < voxels_.size() && voxels_[guess].index == index)
      return guess;
    return static_cast<std::int32_t>(&FindOrAdd(index) - voxels_.data());
  }

  /// Removes the voxels for which `is_gone` is true; the others keep their order.
  template <class Predicate>
  void RemoveIf(Predicate&& is_gone) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < voxels_.size(); ++i) {
      if (is_gone(voxels_[i])) continue;
      if (kept != i) voxels_[kept] = voxels_[i];
      ++kept;
    }
    if (kept == voxels_.size()) return;
    voxels_.resize(kept);
    Rehash(slots_.size());
  }

  void Clear();
  const std::vector<Voxel>& voxels() const { return voxels_; }
  std::vector<Voxel>& voxels() { return voxels_; }

 private:
  struct Slot {
    VoxelIndex index;
    std::int32_t position = -1;  ///< in `voxels_`; -1: empty
  };
  void Rehash(std::size_t slot_count);

  std::vector<Voxel> voxels_;
  std::vector<Slot> slots_;  ///< open addressing, a power of two, at most half full
};

}  // namespace fallen
