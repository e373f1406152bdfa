// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/scene/page_message.hpp"

#include <bit>
#include <cstring>

namespace fallen {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");
constexpr std::size_t kAlignment = 4;

std::size_t Aligned(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

void PageMessage::AddBytes(const std::string& name, const std::string& type,
                           std::span<const std::byte> bytes, std::size_t count) {
  const std::size_t offset = arrays_.size();
  facts_["arrays"][name] = {{"type", type}, {"offset", offset}, {"count", count}};
  arrays_.resize(Aligned(offset + bytes.size()));
  if (!bytes.empty()) std::memcpy(arrays_.data() + offset, bytes.data(), bytes.size());
}

std::vector<std::uint8_t> PageMessage::Encode() const {
  std::string text = facts_.dump();
  text.resize(Aligned(text.size()), ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::vector<std::uint8_t> bytes(sizeof length + text.size() + arrays_.size());
  std::memcpy(bytes.data(), &length, sizeof length);
  std::memcpy(bytes.data() + sizeof length, text.data(), text.size());
  if (!arrays_.empty())
    std::memcpy(bytes.data() + sizeof length + text.size(), arrays_.data(), arrays_.size());
  return bytes;
}

}  // namespace fallen
