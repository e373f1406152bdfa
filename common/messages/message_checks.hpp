// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// What the conversions check of a message's fields. Internal to this folder.
///
/// All throw std::invalid_argument with field, got and expected: `ndt_map_t.frame: got 7, expected
/// 0 to 2`.
namespace fallen::checks {

[[noreturn]] void Fail(std::string_view field, const std::string& got, std::string_view expected);

/// Shortest text that reads back as the same number.
std::string Text(double value);
std::string Text(std::int64_t value);

template <std::integral T>
void InRange(std::string_view field, T value, std::int64_t low, std::int64_t high) {
  const auto wide = static_cast<std::int64_t>(value);
  if (wide < low || wide > high) Fail(field, Text(wide), Text(low) + " to " + Text(high));
}

inline void Finite(std::string_view field, double value) {
  if (!std::isfinite(value)) Fail(field, Text(value), "a finite number");
}

inline void InRange(std::string_view field, double value, double low, double high) {
  if (!(value >= low && value <= high)) Fail(field, Text(value), Text(low) + " to " + Text(high));
}

inline void Positive(std::string_view field, double value) {
  if (!(value > 0) || !std::isfinite(value)) Fail(field, Text(value), "a finite number > 0");
}

/// Every element is finite. Names the first that is not.
template <std::floating_point T>
void AllFinite(std::string_view field, std::span<const T> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      Fail(std::string(field) + "[" + std::to_string(i) + "]", Text(values[i]), "a finite number");
}

/// A count field says how many elements its array has.
inline void Count(std::string_view field, std::int64_t count, std::size_t elements) {
  if (count < 0 || static_cast<std::size_t>(count) != elements)
    Fail(field, Text(count), "the array's size, " + std::to_string(elements));
}

/// A boolean on the wire is one byte: 0 or 1, nothing else.
inline bool Boolean(std::string_view field, std::int8_t value) {
  if (value != 0 && value != 1) Fail(field, Text(std::int64_t{value}), "0 or 1");
  return value == 1;
}

/// A string that fits `max_bytes` and holds no control characters but line breaks and tabs.
void CheckText(std::string_view field, const std::string& text, std::size_t max_bytes);

/// A cell classifier's score, [-1, 1] to within what means of floats lose.
void Score(std::string_view field, double score);

/// A quaternion w x y z of unit length, to within what single precision loses.
void UnitQuaternion(std::string_view field, const double (&wxyz)[4]);

}  // namespace fallen::checks
