// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <string>

#include "fallen/service/logging.hpp"
#include "tools/view/feed/alarm_table.hpp"
#include "tools/view/feed/feed.hpp"
#include "tools/view/feed/scene_assembler.hpp"
#include "tools/view/feed/service_table.hpp"

namespace fallen {

/// Fills a feed with what the services of one camera publish.
class LiveSource {
 public:
  /// @param feed  Must outlive this.
  /// @throws std::runtime_error if LCM cannot be opened.
  LiveSource(Feed& feed, const std::string& lcm_url, const std::string& camera);

  /// Listens until `is_stopping`. Nothing of what arrives can end it.
  void Run(const std::atomic<bool>& is_stopping);

  /// Tells fallen-alarm that somebody at the page takes notice of an alarm. Thread-safe.
  void Acknowledge(const std::string& event_id);

 private:
  void OnMessage(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept;
  void OnStatus(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept;
  void OnAlarm(const lcm::ReceiveBuffer* buffer, const std::string& channel) noexcept;
  void TellServices();

  Feed& feed_;
  lcm::LCM lcm_;
  SceneAssembler assembler_;
  ServiceTable services_;
  AlarmTable alarms_;
  RepeatedWarnings warnings_;
  std::chrono::steady_clock::time_point services_due_;
};

}  // namespace fallen
