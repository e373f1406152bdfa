// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "services/fall_alarm/alarm_history.hpp"
#include "services/fall_alarm/mqtt_connection.hpp"
#include "services/fall_alarm/mqtt_topics.hpp"

namespace fallen {

/// Tells an MQTT broker of every change in a history, in order, each once, and of the state now;
/// takes answers from it. Connects again for as long as it lives.
///
/// A change counts as told when the broker has confirmed it and the history says so. Between the
/// two the process may die: so on each connection the newest event that the broker retains is
/// looked at first, and what it has is not sent again. One thread of its own.
class MqttPublisher {
 public:
  struct Handlers {
    std::function<void(const AlarmAnswer&)> on_answer;  ///< utime is 0
    /// The connection is there (""), or not, and why.
    std::function<void(const std::string& trouble)> on_state;
  };

  /// @param history  Must outlive this.
  /// @throws std::runtime_error for files of `config` that cannot be read.
  MqttPublisher(const MqttConfig& config, const std::string& robot, AlarmHistory& history,
                Handlers handlers);
  /// Tells what is left if the broker is there, then says goodbye.
  ~MqttPublisher();
  MqttPublisher(const MqttPublisher&) = delete;
  MqttPublisher& operator=(const MqttPublisher&) = delete;

 private:
  class Session;
  void Run();
  void Connect();
  bool Wait(std::chrono::milliseconds time) const;

  const MqttLibrary library_;
  const MqttConfig config_;
  const std::string robot_;
  const std::string password_;
  const MqttTopics topics_;
  AlarmHistory& history_;
  const Handlers handlers_;
  std::chrono::milliseconds retry_{0};
  std::atomic<bool> is_stopping_ = false;
  std::thread thread_;
};

}  // namespace fallen
