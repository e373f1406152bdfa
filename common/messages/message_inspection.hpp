// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "fallen/messages/conversions.hpp"

namespace fallen {

/// What bytes from a channel are, told from their hash.
struct MessageFacts {
  std::string type;        ///< of ours, e.g. "depth_image_t"; empty if the hash is not ours
  std::uint64_t hash = 0;  ///< the first 8 bytes; 0 if there are fewer
  std::string error;       ///< why it cannot be decoded or its values make no sense; else empty
  std::optional<Header> header;  ///< of a whole message that has one
};

/// Finds out the type by the hash, then decodes and checks as the services would. Never throws.
MessageFacts InspectMessage(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace fallen
