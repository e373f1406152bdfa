// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <string>
#include <vector>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen::testing_support {

/// Listens to channels of a network and keeps what comes, as bytes.
class LcmRecorder {
 public:
  /// @param channels  Regular expression of those to keep.
  explicit LcmRecorder(const std::string& url, const std::string& channels = ".*");

  lcm::LCM& lcm() { return lcm_; }

  /// Handles what comes until `done` says so. @return false if it did not within `timeout`.
  bool HandleUntil(const std::function<bool()>& done, std::chrono::milliseconds timeout);
  /// Handles what comes for so long.
  void HandleFor(std::chrono::milliseconds time);

  /// Messages of a channel so far, in order.
  const std::vector<std::vector<std::uint8_t>>& Bytes(const std::string& channel) {
    return messages_[channel];
  }
  std::size_t Count(const std::string& channel) { return messages_[channel].size(); }
  template <class Message>
  std::vector<Message> Messages(const std::string& channel) {
    std::vector<Message> decoded;
    for (const auto& bytes : messages_[channel])
      decoded.push_back(DecodeMessage<Message>(bytes).message.value());
    return decoded;
  }
  /// Newest status of a service; all zero before the first.
  service_status_t Status(const std::string& service);
  void Clear() { messages_.clear(); }

 private:
  void Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel);

  lcm::LCM lcm_;
  std::map<std::string, std::vector<std::vector<std::uint8_t>>> messages_;
};

}  // namespace fallen::testing_support
