// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

/// A file around one piece of bytes. Internal to this folder.
///
/// Magic (8 characters), version (4 bytes), CRC-32 (4 bytes) of all that follows it, payload length
/// (8 bytes), payload: one zstd frame. Numbers are big-endian.
namespace fallen {

struct ContainerKind {
  std::string_view magic;  ///< 8 characters
  std::string_view name;   ///< for people: "a model file"
  std::uint32_t version = 1;
};

/// What the container holds.
/// @throws std::runtime_error with path, place, got and expected.
std::vector<std::uint8_t> ReadContainer(const std::filesystem::path& path,
                                        const ContainerKind& kind);

/// Writes beside the target and renames. @throws std::runtime_error if that fails.
void WriteContainer(const std::filesystem::path& path, const ContainerKind& kind,
                    std::span<const std::uint8_t> content);

}  // namespace fallen
