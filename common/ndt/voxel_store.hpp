// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"
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
  Moments moments;  ///< of all frames
  NdtCell cell;     ///< of these moments, if there are enough points
  double log_odds = 0;
  /// Holds points of frames in which no floor was known, so perhaps the floor's.
  bool may_hold_floor = false;
};

/// Points of the newest frame in a voxel, not yet merged: with its index one line of the cache, all
/// that adding a point takes.
struct alignas(64) IncomingPoints {
  std::array<float, 12> sums{};  ///< x y z count, xx xy yy yz, xz xz zz zz
  VoxelIndex index;

  float count() const { return sums[3]; }
  bool IsAt(const VoxelIndex& at) const {
    return ((index.x ^ at.x) | (index.y ^ at.y) | (index.z ^ at.z)) == 0;
  }
};

/// The voxels, found by index through a hash table, and what comes in for each.
class VoxelStore {
 public:
  VoxelStore();

  /// Position in `voxels()` of the voxel at `index`, made if need be. Positions hold until a voxel
  /// is removed.
  std::int32_t FindOrAdd(const VoxelIndex& index);

  /// Likewise. `guess` is looked at first: any number, best the position of a voxel that was met
  /// nearby.
  std::int32_t FindOrAdd(const VoxelIndex& index, std::int32_t guess) {
    if (static_cast<std::size_t>(guess) < incoming_.size() && incoming_[guess].IsAt(index))
      return guess;
    return FindOrAdd(index);
  }

  /// Removes a voxel; the last one takes its position.
  void Remove(std::int32_t position);

  void Clear();
  std::int32_t size() const { return static_cast<std::int32_t>(voxels_.size()); }
  const std::vector<Voxel>& voxels() const { return voxels_; }
  std::vector<Voxel>& voxels() { return voxels_; }
  /// One a voxel; indices are not to be changed.
  std::vector<IncomingPoints>& incoming() { return incoming_; }

 private:
  std::size_t SlotOf(const VoxelIndex& index) const;
  void EmptySlot(std::size_t at);
  void Rehash(std::size_t slot_count);

  std::vector<Voxel> voxels_;
  std::vector<IncomingPoints> incoming_;
  /// Positions, or kEmpty: open addressing, a power of two, at most half full.
  std::vector<std::int32_t> slots_;
  static constexpr std::int32_t kEmpty = -1;
};

}  // namespace fallen
