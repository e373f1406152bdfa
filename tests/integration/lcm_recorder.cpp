// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/lcm_recorder.hpp"

#include <stdexcept>

#include "fallen/service/channels.hpp"

namespace fallen::testing_support {

using std::chrono::milliseconds;

LcmRecorder::LcmRecorder(const std::string& url, const std::string& channels) : lcm_(url) {
  if (!lcm_.good()) throw std::runtime_error("cannot open " + url);
  lcm_.subscribe(channels, &LcmRecorder::Receive, this)->setQueueCapacity(0);
}

void LcmRecorder::Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  const auto* bytes = static_cast<const std::uint8_t*>(buffer->data);
  messages_[channel].emplace_back(bytes, bytes + buffer->data_size);
}

bool LcmRecorder::HandleUntil(const std::function<bool()>& done, milliseconds timeout) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!done()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    lcm_.handleTimeout(10);
  }
  return true;
}

void LcmRecorder::HandleFor(milliseconds time) {
  HandleUntil([] { return false; }, time);
}

service_status_t LcmRecorder::Status(const std::string& service) {
  const auto& statuses = messages_[channels::Status(service)];
  if (statuses.empty()) return {};
  return DecodeMessage<service_status_t>(statuses.back()).message.value();
}

}  // namespace fallen::testing_support
