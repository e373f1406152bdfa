// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/log_check/log_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "fallen/messages/message_inspection.hpp"

namespace fallen {
namespace {

// Bytes of an event beside channel and data.
constexpr std::size_t kEventHeaderBytes = 28;

std::string TypeName(const MessageFacts& facts) {
  if (!facts.type.empty()) return facts.type;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "unknown 0x%016llx",
                static_cast<unsigned long long>(facts.hash));
  return text.data();
}

void AddTime(ChannelReport& channel, std::int64_t utime) {
  channel.first_utime = channel.messages == 0 ? utime : std::min(channel.first_utime, utime);
  channel.last_utime = channel.messages == 0 ? utime : std::max(channel.last_utime, utime);
}

void AddSequence(ChannelReport& channel, std::optional<std::int64_t>& last, std::int64_t seq) {
  if (last && seq <= *last) ++channel.out_of_order;
  if (last && seq > *last) channel.missing += seq - *last - 1;
  last = seq;
}

}  // namespace

std::int64_t LogReport::damaged_bytes() const {
  std::int64_t bytes = 0;
  for (const LogDamage& place : damage) bytes += place.skipped_bytes;
  return bytes;
}

std::int64_t LogReport::bad_messages() const {
  std::int64_t count = 0;
  for (const auto& [name, channel] : channels)
    count += static_cast<std::int64_t>(channel.bad.size());
  return count;
}

LogReport CheckLog(const std::filesystem::path& log, LogWriter* repaired,
                   const std::function<void(double)>& progress) {
  LogReader reader(log);
  LogReport report;
  std::map<std::string, std::optional<std::int64_t>> last_seq;
  while (const auto event = reader.Next()) {
    const MessageFacts facts = InspectMessage(event->data);
    ChannelReport& channel = report.channels[event->channel];
    AddTime(channel, event->utime);
    ++report.events;
    ++channel.messages;
    ++channel.types[TypeName(facts)];
    channel.bytes += static_cast<std::int64_t>(event->data.size());
    if (facts.header) AddSequence(channel, last_seq[event->channel], facts.header->seq);
    if (!facts.error.empty()) {
      const std::size_t size = kEventHeaderBytes + event->channel.size() + event->data.size();
      channel.bad.push_back(
          {reader.position_bytes() - static_cast<std::int64_t>(size), facts.error});
    } else if (repaired != nullptr) {
      repaired->Write(event->utime, event->channel, event->data);
    }
    if (progress)
      progress(static_cast<double>(reader.position_bytes()) /
               static_cast<double>(reader.size_bytes()));
  }
  report.damage = reader.damage();
  report.size_bytes = reader.size_bytes();
  return report;
}

}  // namespace fallen
