// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "fallen/service/alarm_output_config.hpp"

struct mosquitto;
struct mosquitto_message;

namespace fallen {

/// One connection to an MQTT broker, from its opening to its loss: never opened again, so that
/// nothing is sent twice behind the owner's back. QoS 1 throughout. For one thread.
class MqttConnection {
 public:
  struct Handlers {
    std::function<void()> on_connected;
    std::function<void(int message)> on_subscribed;
    std::function<void(int message)> on_delivered;  ///< the broker has it
    std::function<void(const std::string& topic, const std::string& payload, bool is_retained)>
        on_message;
  };

  /// Begins to connect.
  /// @param client_id  The broker keeps what is sent to it while it is away.
  /// @param will_topic Gets `will`, retained, when the connection is lost.
  /// @throws std::runtime_error for a host that cannot be found.
  MqttConnection(const MqttConfig& config, const std::string& password,
                 const std::string& client_id, const std::string& will_topic,
                 const std::string& will, Handlers handlers);
  ~MqttConnection();
  MqttConnection(const MqttConnection&) = delete;
  MqttConnection& operator=(const MqttConnection&) = delete;

  /// Sends and receives for at most so long; calls the handlers.
  /// @throws std::runtime_error "mqtt: <host>:<port>: <why>" once the connection is lost or
  /// refused.
  void Loop(std::chrono::milliseconds timeout);

  /// Sends a retained message. @return Its number, for on_delivered.
  int Publish(const std::string& topic, const std::string& payload);
  /// @return Its number, for on_subscribed.
  int Subscribe(const std::vector<std::string>& topics);
  void Unsubscribe(const std::string& topic);
  void Disconnect();

 private:
  struct Callbacks;
  void Connect();
  void LoopOnce(std::chrono::milliseconds timeout);
  void Require(int status, const std::string& what);
  void RequireAlive() const;
  [[noreturn]] void Fail(const std::string& why) const;

  const std::string host_;
  const int port_;
  const std::string broker_;
  Handlers handlers_;
  mosquitto* client_ = nullptr;
  bool is_answered_ = false;
  /// Of a host with several addresses the library tries the first, which is the IPv6 one: what has
  /// not answered there is tried once more at its IPv4 address.
  bool is_ipv4_only_ = false;
  int connect_error_ = 0;      ///< errno of the call that began to connect
  std::string refusal_;        ///< why the broker does not want us
  std::string library_error_;  ///< newest, for what only the library's log tells
};

/// Sets the library up for the process, while it lives.
class MqttLibrary {
 public:
  MqttLibrary();
  ~MqttLibrary();
  MqttLibrary(const MqttLibrary&) = delete;
  MqttLibrary& operator=(const MqttLibrary&) = delete;
};

}  // namespace fallen
