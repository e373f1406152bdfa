// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/service_table.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "fallen/messages/guarded_decoding.hpp"

namespace fallen {
namespace {

/// A service that has said nothing for so long is forgotten: it was stopped for good.
constexpr std::chrono::minutes kForgetAfter{5};
/// More are no deployment of ours.
constexpr std::size_t kMaxServices = 64;

std::string StateName(std::int8_t state) {
  constexpr std::array kNames = {"starting", "running", "degraded", "lost", "stopping"};
  const auto index = static_cast<std::size_t>(state);
  return state >= 0 && index < kNames.size() ? kNames[index] : "unknown";
}

}  // namespace

void ServiceTable::Take(std::span<const std::uint8_t> bytes, Clock::time_point now) {
  Decoded<service_status_t> decoded = DecodeMessage<service_status_t>(bytes);
  if (!decoded) throw std::invalid_argument(decoded.error);
  std::erase_if(heard_, [&](const auto& entry) { return now - entry.second.at > kForgetAfter; });
  service_status_t& status = *decoded.message;
  // A new process in the place of one that has gone: not two services.
  std::erase_if(heard_, [&](const auto& entry) {
    const bool is_gone = now - entry.second.at > std::chrono::seconds(3) ||
                         entry.second.status.state == service_status_t::STOPPING;
    return entry.first.first == status.service && entry.first.second != status.pid && is_gone;
  });
  const auto key = std::make_pair(status.service, status.pid);
  if (heard_.size() >= kMaxServices && !heard_.contains(key)) return;
  heard_[key] = {std::move(status), now};
}

nlohmann::json ServiceTable::ToJson(Clock::time_point now) const {
  nlohmann::json table = nlohmann::json::array();
  for (const auto& [key, heard] : heard_) {
    const service_status_t& status = heard.status;
    table.push_back({{"service", status.service},
                     {"camera", status.header.sensor_name},
                     {"version", status.version},
                     {"pid", status.pid},
                     {"state", StateName(status.state)},
                     {"text", status.text},
                     {"received", status.received},
                     {"published", status.published},
                     {"dropped_late", status.dropped_late},
                     {"dropped_damaged", status.dropped_damaged},
                     {"lost_upstream", status.lost_upstream},
                     {"rate_hz", status.rate_hz},
                     {"median_ms", status.median_ms},
                     {"p99_ms", status.p99_ms},
                     {"resident_bytes", status.resident_bytes},
                     {"silent_s", std::chrono::duration<double>(now - heard.at).count()}});
  }
  return table;
}

}  // namespace fallen
