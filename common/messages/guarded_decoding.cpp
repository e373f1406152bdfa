// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/guarded_decoding.hpp"

#include <array>
#include <cstdio>
#include <exception>

#include "fallen/baseline_model_t.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/depth_image_t.hpp"
#include "fallen/environment_map_t.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/ground_truth_t.hpp"
#include "fallen/messages/log_format.hpp"
#include "fallen/messages/wire_layout.hpp"
#include "fallen/model_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/pose_t.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen {
namespace {

constexpr std::size_t kHashBytes = 8;

std::string HashText(std::uint64_t hash) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "0x%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

// Why `bytes` do not begin with this hash; empty if they do.
std::string ExamineHash(std::span<const std::uint8_t> bytes, std::int64_t hash) {
  if (bytes.size() < kHashBytes)
    return "got " + std::to_string(bytes.size()) + " bytes, expected " +
           std::to_string(kHashBytes) + " or more";
  if (bytes.size() > static_cast<std::size_t>(log_format::kMaxDataBytes))
    return "got " + std::to_string(bytes.size()) + " bytes, expected at most " +
           std::to_string(log_format::kMaxDataBytes);
  const auto got = log_format::ReadBigEndian<std::uint64_t>(bytes.data());
  if (got != static_cast<std::uint64_t>(hash))
    return "got a message of another type (hash " + HashText(got) + "), expected " +
           HashText(static_cast<std::uint64_t>(hash));
  return {};
}

// Why `bytes` are no message with this hash and layout; empty if they are one.
std::string Examine(std::span<const std::uint8_t> bytes, std::int64_t hash,
                    const wire::Layout& layout) {
  const std::string wrong = ExamineHash(bytes, hash);
  if (!wrong.empty()) return std::string(layout.name) + ": " + wrong;
  return wire::Check(layout, bytes.subspan(kHashBytes));
}

}  // namespace

template <class Message>
Decoded<Message> DecodeMessage(std::span<const std::uint8_t> bytes) noexcept {
  Decoded<Message> decoded;
  try {
    decoded.error = Examine(bytes, Message::getHash(), wire::LayoutOf<Message>());
    if (!decoded.error.empty()) return decoded;
    Message message{};
    const int size = static_cast<int>(bytes.size());
    const int read = message.decode(bytes.data(), 0, size);
    if (read == size)
      decoded.message = std::move(message);
    else
      decoded.error = std::string(Message::getTypeName()) + ": decoding ended at byte " +
                      std::to_string(read) + ", expected " + std::to_string(size);
  } catch (const std::exception&) {
    decoded.message.reset();
    decoded.error = "out of memory";  // short enough to need none itself
  }
  return decoded;
}

std::optional<header_t> DecodeHeader(std::span<const std::uint8_t> bytes,
                                     std::int64_t hash) noexcept {
  try {
    if (!ExamineHash(bytes, hash).empty()) return std::nullopt;
    const auto content = bytes.subspan(kHashBytes);
    if (!wire::CheckStart(wire::LayoutOf<header_t>(), content).empty()) return std::nullopt;
    header_t header{};
    if (header._decodeNoHash(content.data(), 0, static_cast<int>(content.size())) < 0)
      return std::nullopt;
    return header;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

template Decoded<pose_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<depth_image_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<ndt_map_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<clusters_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<fallen_persons_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<ground_truth_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<service_status_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<model_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<baseline_model_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<environment_map_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<fall_alarm_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;
template Decoded<fall_alarm_ack_t> DecodeMessage(std::span<const std::uint8_t>) noexcept;

}  // namespace fallen
