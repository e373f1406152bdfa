// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <vector>

#include "fallen/messages/log_file.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen::testing_support {

/// A service in this process on memq://: what is sent to it is handled at once, what it answers
/// kept.
class MemqLink {
 public:
  MemqLink() : lcm_("memq://") {}

  lcm::LCM& lcm() { return lcm_; }

  static StageOptions Options(const std::string& service) {
    StageOptions options;
    options.service = service;
    options.lossless = true;
    return options;
  }

  void Collect(const std::string& channel) {
    lcm_.subscribe(channel, &MemqLink::Receive, this)->setQueueCapacity(0);
  }
  void Send(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
    lcm_.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
  }
  template <class Message>
  void SendMessage(const std::string& channel, const Message& message) {
    Send(channel, EncodeMessage(message));
  }
  /// Delivers what was sent, lets the service work it off, and takes its answers.
  void Exchange(StageLoop& loop) {
    Deliver();
    loop.HandleWaiting();
    Deliver();
  }
  const std::vector<std::vector<std::uint8_t>>& answers() const { return answers_; }

 private:
  void Deliver() {
    while (lcm_.handleTimeout(0) > 0) {
    }
  }
  void Receive(const lcm::ReceiveBuffer* buffer, const std::string&) {
    const auto* bytes = static_cast<const std::uint8_t*>(buffer->data);
    answers_.emplace_back(bytes, bytes + buffer->data_size);
  }

  lcm::LCM lcm_;
  std::vector<std::vector<std::uint8_t>> answers_;
};

}  // namespace fallen::testing_support
