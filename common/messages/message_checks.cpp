// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/message_checks.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace fallen::checks {
namespace {

// A quaternion that went through floats is off by 1e-7; one that was never normalised by far more.
constexpr double kQuaternionTolerance = 1e-3;
constexpr double kScoreTolerance = 1e-3;

}  // namespace

void Fail(std::string_view field, const std::string& got, std::string_view expected) {
  throw std::invalid_argument(std::string(field) + ": got " + got + ", expected " +
                              std::string(expected));
}

std::string Text(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

std::string Text(std::int64_t value) { return std::to_string(value); }

void CheckText(std::string_view field, const std::string& text, std::size_t max_bytes) {
  if (text.size() > max_bytes)
    Fail(field, std::to_string(text.size()) + " bytes", "at most " + std::to_string(max_bytes));
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
  };
  const auto bad = std::find_if(text.begin(), text.end(), is_control);
  if (bad != text.end())
    Fail(field, "control character " + std::to_string(static_cast<unsigned char>(*bad)),
         "printable text");
}

void Score(std::string_view field, double score) {
  InRange(field, score, -1 - kScoreTolerance, 1 + kScoreTolerance);
}

void UnitQuaternion(std::string_view field, const double (&wxyz)[4]) {
  AllFinite(field, std::span<const double>(wxyz));
  double sq_norm = 0;
  for (const double value : wxyz) sq_norm += value * value;
  const double norm = std::sqrt(sq_norm);
  if (!(std::abs(norm - 1) <= kQuaternionTolerance))
    Fail(field, "length " + Text(norm), "a unit quaternion");
}

}  // namespace fallen::checks
