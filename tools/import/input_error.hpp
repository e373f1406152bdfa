// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fallen {

/// Says what is wrong with an input file: "<file>:<line>: got <got>, expected <expected>".
class InputError : public std::runtime_error {
 public:
  /// @param line  From 1; 0 where the whole file is meant.
  InputError(const std::filesystem::path& file, int line, const std::string& got,
             const std::string& expected)
      : std::runtime_error(file.string() + (line > 0 ? ":" + std::to_string(line) : "") + ": got " +
                           got + ", expected " + expected) {}
};

}  // namespace fallen
