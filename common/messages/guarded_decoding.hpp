// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "fallen/header_t.hpp"

/// Guarded decoding: lengths are checked against the bytes present before anything is allocated.
///
/// Code that lcm-gen makes throws, allocates gigabytes or writes out of bounds for hostile lengths,
/// so nothing here calls it before the layout of the message has been walked through.
namespace fallen {

/// A message, or why the bytes are none.
template <class Message>
struct Decoded {
  std::optional<Message> message;
  std::string error;  ///< empty with a message; else what, where, got, expected

  explicit operator bool() const { return message.has_value(); }
};

/// Decodes one message of a type of ours. Never throws, whatever the bytes.
/// Instantiated for every type in lcmtypes/ that travels alone or in a file.
template <class Message>
Decoded<Message> DecodeMessage(std::span<const std::uint8_t> bytes) noexcept;

/// Decodes the header alone: whose the message is, at no cost however large it is. What follows the
/// header is not looked at. Never throws.
/// @return Nothing if `bytes` do not begin like a message of the type with `hash`
///         (Message::getHash()), a type with a header.
std::optional<header_t> DecodeHeader(std::span<const std::uint8_t> bytes,
                                     std::int64_t hash) noexcept;

}  // namespace fallen
