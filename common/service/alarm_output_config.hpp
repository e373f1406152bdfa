// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace fallen {

/// Where fallen-alarm keeps what happened.
struct HistoryConfig {
  /// SQLite file; empty: $XDG_STATE_HOME/fallen/alarms.db, else ~/.local/state/fallen/alarms.db.
  std::string file;
  bool snapshots = true;  ///< keep depth image, map and pose of the frame that raised an alarm

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("file", file);
    visit("snapshots", snapshots);
  }
};

/// The broker that fallen-alarm tells. The password is in a file of its own: configurations are
/// logged.
struct MqttConfig {
  std::string host;                                ///< empty: no MQTT
  int port = 8883;                                 ///< 1 to 65535
  bool tls = true;                                 ///< the broker's certificate must be for `host`
  std::string ca_file;                             ///< PEM; empty: the system's authorities
  std::string username;                            ///< empty: none
  std::string password_file;                       ///< its first line; empty: none
  std::string topic = "fallen";                    ///< <topic>/<robot>/...
  std::string discovery_prefix = "homeassistant";  ///< empty: no Home Assistant discovery

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("host", host);
    visit("port", port);
    visit("tls", tls);
    visit("ca_file", ca_file);
    visit("username", username);
    visit("password_file", password_file);
    visit("topic", topic);
    visit("discovery_prefix", discovery_prefix);
  }
};

}  // namespace fallen
