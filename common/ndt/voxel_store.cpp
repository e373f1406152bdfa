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

// The slot that holds `index`, or the empty one where it would go.
std::size_t VoxelStore::SlotOf(const VoxelIndex& index) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = Hash(index) & mask;
  while (slots_[at].position >= 0 && !(slots_[at].index == index)) at = (at + 1) & mask;
  return at;
}

std::int32_t VoxelStore::FindOrAdd(const VoxelIndex& index) {
  const std::size_t at = SlotOf(index);
  if (slots_[at].position >= 0) return slots_[at].position;

  const std::int32_t position = size();
  slots_[at] = {index, position};
  voxels_.emplace_back().index = index;
  incoming_.emplace_back().index = index;
  if (2 * voxels_.size() > slots_.size()) Rehash(2 * slots_.size());
  return position;
}

void VoxelStore::Remove(std::int32_t position) {
  EmptySlot(SlotOf(voxels_[position].index));
  if (position + 1 < size()) {
    slots_[SlotOf(voxels_.back().index)].position = position;
    voxels_[position] = voxels_.back();
    incoming_[position] = incoming_.back();
  }
  voxels_.pop_back();
  incoming_.pop_back();
}

// Moves what was displaced by the slot's entry nearer to where its search begins, so that no search
// ends too early at the gap.
void VoxelStore::EmptySlot(std::size_t at) {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t next = (at + 1) & mask; slots_[next].position >= 0; next = (next + 1) & mask) {
    const std::size_t home = Hash(slots_[next].index) & mask;
    if (((next - home) & mask) < ((next - at) & mask)) continue;  // would come before its home
    slots_[at] = slots_[next];
    at = next;
  }
  slots_[at] = {};
}

void VoxelStore::Clear() {
  voxels_.clear();
  incoming_.clear();
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
