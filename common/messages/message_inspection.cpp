// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/message_inspection.hpp"

#include <exception>

#include "fallen/messages/baseline_files.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_format.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen {
namespace {

// What a receiver makes of a message of each type.
template <class Message>
void Use(const Message& message) {
  FromMessage(message);
}
void Use(const ndt_map_t& message) {
  if (message.flag_count > 0)
    ForegroundFromMessage(message);
  else
    NdtMapFromMessage(message);
}
void Use(const service_status_t& message) { FromMessage(message.header); }

template <class Message>
bool InspectAs(std::span<const std::uint8_t> bytes, MessageFacts& facts) {
  if (facts.hash != static_cast<std::uint64_t>(Message::getHash())) return false;
  facts.type = Message::getTypeName();
  const Decoded<Message> decoded = DecodeMessage<Message>(bytes);
  if (!decoded) {
    facts.error = decoded.error;
    return true;
  }
  Use(*decoded.message);
  if constexpr (requires { decoded.message->header; })
    facts.header = FromMessage(decoded.message->header);
  return true;
}

template <class... Messages>
void InspectAsAny(std::span<const std::uint8_t> bytes, MessageFacts& facts) {
  static_cast<void>((InspectAs<Messages>(bytes, facts) || ...));
}

}  // namespace

MessageFacts InspectMessage(std::span<const std::uint8_t> bytes) noexcept {
  MessageFacts facts;
  try {
    if (bytes.size() < sizeof facts.hash) return facts;
    facts.hash = log_format::ReadBigEndian<std::uint64_t>(bytes.data());
    InspectAsAny<pose_t, depth_image_t, ndt_map_t, clusters_t, fallen_persons_t, ground_truth_t,
                 service_status_t, model_t, baseline_model_t, environment_map_t, fall_alarm_t,
                 fall_alarm_ack_t>(bytes, facts);
  } catch (const std::exception& error) {
    facts.error = error.what();
  }
  return facts;
}

}  // namespace fallen
