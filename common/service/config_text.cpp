// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/config_text.hpp"

#include <charconv>

namespace fallen {

std::string ConfigText(bool value) { return value ? "true" : "false"; }

std::string ConfigText(std::int32_t value) { return std::to_string(value); }

std::string ConfigText(std::int64_t value) { return std::to_string(value); }

std::string ConfigText(double value) {
  char buffer[32];  // the longest shortest form has 24 characters
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string ConfigText(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

}  // namespace fallen
