// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// What LCM puts on the wire for a type, and whether bytes can be that. Internal to this folder.
///
/// All numbers big-endian, without padding; strings as length (4 bytes, counting the final 0),
/// characters, 0; arrays without a length of their own (a field before them says it); structs in
/// place.
namespace fallen::wire {

enum class Kind : std::uint8_t {
  kByte,
  kBoolean,
  kInt8,
  kInt16,
  kInt32,
  kInt64,
  kFloat,
  kDouble,
  kString,
  kStruct
};

/// One dimension of an array: a number, or the int32 field of the same struct that says it.
struct Dimension {
  std::int32_t fixed = 1;
  std::string_view count_field = {};

  constexpr Dimension() = default;
  constexpr Dimension(std::int32_t size) : fixed(size) {}  // NOLINT(google-explicit-constructor)
  constexpr Dimension(std::string_view field)
      : count_field(field) {}  // NOLINT(google-explicit-constructor)
  constexpr Dimension(const char* field)
      : count_field(field) {}  // NOLINT(google-explicit-constructor)
  constexpr bool is_variable() const { return !count_field.empty(); }
};

struct Layout;

/// A member of a struct; a scalar has dimensions 1 x 1.
struct Field {
  Kind kind;
  std::string_view name;
  Dimension outer = {};
  Dimension inner = {};
  const Layout* layout = nullptr;  ///< of a kStruct
};

struct Layout {
  std::string_view name;  ///< as in the .lcm file
  std::span<const Field> fields;
};

/// Layout of the message type that lcm-gen calls `Message`.
template <class Message>
const Layout& LayoutOf();

/// Walks `bytes`, a message without its hash, and compares every length with the bytes present.
///
/// After it says yes, the generated decode allocates no more than a small multiple of bytes.size().
/// @return Empty if the bytes are one whole message; else field, got, expected.
std::string Check(const Layout& layout, std::span<const std::uint8_t> bytes);

/// The same for bytes that only begin with such a struct.
std::string CheckStart(const Layout& layout, std::span<const std::uint8_t> bytes);

}  // namespace fallen::wire
