// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "fallen/messages/container_file.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"

/// A container file that holds one encoded message. Internal to this folder.
namespace fallen {

/// What the message in the file stands for, by its FromMessage.
/// @throws std::runtime_error naming file, place, got and expected.
template <class Message>
auto LoadMessageFile(const std::filesystem::path& path, const ContainerKind& kind) {
  const std::vector<std::uint8_t> bytes = ReadContainer(path, kind);
  const Decoded<Message> decoded = DecodeMessage<Message>(bytes);
  if (!decoded) throw std::runtime_error(path.string() + ": " + decoded.error);
  try {
    return FromMessage(*decoded.message);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace fallen
