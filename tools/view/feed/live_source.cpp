// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/live_source.hpp"

#include <span>
#include <stdexcept>

#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

constexpr int kPollMs = 100;
constexpr std::chrono::seconds kServicesInterval{1};

std::span<const std::uint8_t> Bytes(const lcm::ReceiveBuffer* buffer) {
  return {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size};
}

}  // namespace

LiveSource::LiveSource(Feed& feed, const std::string& lcm_url, const std::string& camera)
    : feed_(feed),
      lcm_(lcm_url),
      assembler_(camera, [this](const Scene& scene) { feed_.Append(scene); }) {
  if (!lcm_.good()) throw std::runtime_error(lcm_url + ": LCM cannot be opened, run fallen-doctor");
  lcm_.subscribe(AssembledChannels(camera), &LiveSource::OnMessage, this);
  lcm_.subscribe("STATUS_.*", &LiveSource::OnStatus, this);
  lcm_.subscribe(channels::kFallAlarm, &LiveSource::OnAlarm, this);
  feed_.SetTopic("source", {{"mode", "live"}, {"name", lcm_url}, {"camera", camera}});
  TellServices();
}

void LiveSource::Run(const std::atomic<bool>& is_stopping) {
  while (!is_stopping) {
    lcm_.handleTimeout(kPollMs);
    if (std::chrono::steady_clock::now() >= services_due_) TellServices();
  }
}

void LiveSource::Acknowledge(const std::string& event_id) {
  AlarmAnswer answer;
  answer.event_id = event_id;
  answer.by = "the page";
  const fall_alarm_ack_t message = ToMessage(answer);
  lcm_.publish(channels::kFallAlarmAck, &message);
}

// Nothing thrown leaves a handler: LCM calls them from C.
void LiveSource::OnMessage(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept {
  try {
    assembler_.Take(channel, Bytes(buffer));
  } catch (const std::exception& error) {
    warnings_.Warn(channel, channel + ": " + error.what());
  }
}

void LiveSource::OnStatus(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept {
  try {
    services_.Take(Bytes(buffer), std::chrono::steady_clock::now());
  } catch (const std::exception& error) {
    warnings_.Warn(channel, channel + ": " + error.what());
  }
}

void LiveSource::OnAlarm(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept {
  try {
    if (alarms_.Take(Bytes(buffer))) feed_.SetTopic("alarms", alarms_.ToJson());
  } catch (const std::exception& error) {
    warnings_.Warn(channel, channel + ": " + error.what());
  }
}

void LiveSource::TellServices() {
  const auto now = std::chrono::steady_clock::now();
  feed_.SetTopic("services", services_.ToJson(now));
  services_due_ = now + kServicesInterval;
}

}  // namespace fallen
