// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "services/fall_alarm/mqtt_connection.hpp"
#include "tests/support/child_process.hpp"

namespace fallen::testing_support {

/// Debian's mosquitto on a loopback port of the test's own: TLS with a certificate for "localhost",
/// made on the spot, and one user, "fallen" with the password "secret". Keeps retained messages and
/// sessions on disk, as a broker does that is to survive.
class MosquittoBroker {
 public:
  /// @param folder  Of this broker; missing ones are made.
  explicit MosquittoBroker(const std::filesystem::path& folder);

  /// True if mosquitto, its clients and openssl are there.
  static bool IsInstalled();

  void Start();
  void Kill();

  int port() const { return port_; }
  /// How to reach it, as the section mqtt of a configuration.
  MqttConfig Config() const;
  /// The same as YAML.
  std::string Yaml() const;
  /// Makes an authority and a certificate for `host`; returns the authority's file.
  std::filesystem::path MakeCertificate(const std::string& name, const std::string& host);

 private:
  std::filesystem::path folder_;
  int port_ = 0;
  std::optional<ChildProcess> process_;
};

/// Somebody who listens to a broker and keeps what comes; connects again when the broker is back.
class MqttListener {
 public:
  struct Message {
    std::string topic;
    std::string payload;
    bool is_retained;
  };
  MqttListener(const MosquittoBroker& broker, const std::string& client_id,
               std::vector<std::string> topics);

  /// Listens until `done` says so. @return false if it did not within `timeout`.
  bool ListenUntil(const std::function<bool()>& done, std::chrono::milliseconds timeout);
  void ListenFor(std::chrono::milliseconds time);
  bool is_subscribed() const { return is_subscribed_; }

  /// All that has come, in order.
  const std::vector<Message>& messages() const { return messages_; }
  /// Newest payload of a topic; "" before the first.
  std::string Newest(const std::string& topic) const;
  std::vector<std::string> Payloads(const std::string& topic) const;

 private:
  void Connect();

  const MqttLibrary library_;
  MqttConfig config_;
  std::string client_id_;
  std::vector<std::string> topics_;
  bool is_subscribed_ = false;
  std::vector<Message> messages_;
  std::unique_ptr<MqttConnection> connection_;
};

}  // namespace fallen::testing_support
