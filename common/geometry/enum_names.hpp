// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fallen {

/// Table of an enum's values and their names in configuration files, found by argument-dependent
/// lookup. An enum takes part by defining, beside itself,
/// `constexpr auto EnumNames(MyEnum) { return EnumTable<MyEnum, 2>{{{MyEnum::kA, "a"}, ...}}; }`.
template <class Enum, std::size_t N>
using EnumTable = std::array<std::pair<Enum, std::string_view>, N>;

/// Name of `value`, or "unknown" for a value that the table does not list.
template <class Enum>
constexpr std::string_view EnumName(Enum value) {
  for (const auto& [candidate, name] : EnumNames(Enum{}))
    if (candidate == value) return name;
  return "unknown";
}

/// Value called `name`, if there is one.
template <class Enum>
constexpr std::optional<Enum> EnumFromName(std::string_view name) {
  for (const auto& [value, candidate] : EnumNames(Enum{}))
    if (candidate == name) return value;
  return std::nullopt;
}

}  // namespace fallen
