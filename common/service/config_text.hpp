// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "fallen/geometry/enum_names.hpp"

/// One-line YAML of configuration structs by their `Visit`: for logs, and to be pasted into a file.
namespace fallen {

std::string ConfigText(bool value);
std::string ConfigText(std::int32_t value);
std::string ConfigText(std::int64_t value);
/// Shortest text that reads back as the same number.
std::string ConfigText(double value);
/// In double quotes.
std::string ConfigText(const std::string& value);

template <class Enum>
requires std::is_enum_v<Enum> std::string ConfigText(Enum value) {
  return std::string(EnumName(value));
}

template <class T, std::size_t N>
std::string ConfigText(const std::array<T, N>& value) {
  std::string text = "[";
  for (std::size_t i = 0; i < N; ++i) text += (i ? ", " : "") + ConfigText(value[i]);
  return text + "]";
}

template <class T>
std::string ConfigText(const std::optional<T>& value) {
  return value ? ConfigText(*value) : "null";
}

/// "{key: value, ...}" of a struct with `Visit`.
template <class Config>
requires requires(Config c) {
  c.Visit([](const char*, auto&) {});
}
std::string ConfigText(Config config) {
  std::string text = "{";
  config.Visit([&](const char* key, auto& value) {
    text += (text.size() > 1 ? ", " : "") + std::string(key) + ": " + ConfigText(value);
  });
  return text + "}";
}

}  // namespace fallen
