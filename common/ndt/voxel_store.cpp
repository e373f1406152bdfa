// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/voxel_store.hpp"

namespace fallen {
namespace {

// Room for 8 192 voxels, a furnished room's worth, before the table grows.
constexpr std::size_t kInitialSlots = 16384;

// Odd multipliers with well mixed bits, the high half folded down for the table's mask.
std::size_t Hash(const VoxelIndex& index) {
  const auto word = [](std::int32_t value) {
    return std::uint64_t{static_cast<std::uint32_t>(value)};
  };
  std::uint64_t hash = word(index.x) * 0x9E3779B97F4A7C15u;
  hash ^= word(index.y) * 0xC2B2AE3D27D4EB4Fu;
  hash ^= word(index.z) * 0x165667B19E3779F9u;
  return hash ^ (hash >> 32);
}

}  // namespace

VoxelStore::VoxelStore() : slots_(kInitialSlots) {}

Voxel& VoxelStore::FindOrAdd(const VoxelIndex& index) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = Hash(index) & mask;
  for (; slots_[at].position >= 0; at = (at + 1) & mask)
    if (slots_[at].index == index) return voxels_[slots_[at].position];

  slots_[at] = {index, static_cast<std::int32_t>(voxels_.size())};
  Voxel voxel;
  voxel.index = index;
  voxels_.push_back(voxel);
  if (2 * voxels_.size() > slots_.size()) Rehash(2 * slots_.size());
  return voxels_.back();
}

void VoxelStore::Clear() {
  voxels_.clear();
  slots_.assign(slots_.size(), Slot{});
}

void VoxelStore::Rehash(std::size_t slot_count) {
  slots_.assign(slot_count, Slot{});
  const std::size_t mask = slot_count - 1;
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    std::size_t at = Hash(voxels_[i].index) & mask;
    while (slots_[at].position >= 0) at = (at + 1) & mask;
    slots_[at] = {voxels_[i].index, static_cast<std::int32_t>(i)};
  }
}

}  // namespace fallen
