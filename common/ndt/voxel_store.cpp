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

VoxelStore::VoxelStore() : slots_(kInitialSlots, kEmpty) {}

// The slot that holds `index`, or the empty one where it would go.
std::size_t VoxelStore::SlotOf(const VoxelIndex& index) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = Hash(index) & mask;
  while (slots_[at] != kEmpty && !incoming_[slots_[at]].IsAt(index)) at = (at + 1) & mask;
  return at;
}

std::int32_t VoxelStore::FindOrAdd(const VoxelIndex& index) {
  const std::size_t at = SlotOf(index);
  if (slots_[at] != kEmpty) return slots_[at];

  const std::int32_t position = size();
  slots_[at] = position;
  voxels_.emplace_back().index = index;
  incoming_.emplace_back().index = index;
  if (2 * voxels_.size() > slots_.size()) Rehash(2 * slots_.size());
  return position;
}

void VoxelStore::Remove(std::int32_t position) {
  EmptySlot(SlotOf(voxels_[position].index));
  if (position + 1 < size()) {
    slots_[SlotOf(voxels_.back().index)] = position;
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
  for (std::size_t next = (at + 1) & mask; slots_[next] != kEmpty; next = (next + 1) & mask) {
    const std::size_t home = Hash(incoming_[slots_[next]].index) & mask;
    if (((next - home) & mask) < ((next - at) & mask)) continue;  // would come before its home
    slots_[at] = slots_[next];
    at = next;
  }
  slots_[at] = kEmpty;
}

void VoxelStore::Clear() {
  voxels_.clear();
  incoming_.clear();
  slots_.assign(slots_.size(), kEmpty);
}

void VoxelStore::Rehash(std::size_t slot_count) {
  slots_.assign(slot_count, kEmpty);
  const std::size_t mask = slot_count - 1;
  for (std::int32_t position = 0; position < size(); ++position) {
    std::size_t at = Hash(incoming_[position].index) & mask;
    while (slots_[at] != kEmpty) at = (at + 1) & mask;
    slots_[at] = position;
  }
}

}  // namespace fallen
