// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/doctor/finding.hpp"

/// Whether LCM's messages get from one process to another on this machine.
namespace fallen {

/// Where a udpm URL sends.
struct MulticastGroup {
  std::string address = "239.255.76.67";  // LCM's own defaults
  std::uint16_t port = 7667;
};
/// Nothing for a URL that is not udpm. @throws std::invalid_argument for an address or port that is
/// none.
std::optional<MulticastGroup> GroupOf(const std::string& lcm_url);

/// What the system does with packets to a group.
struct MulticastRoute {
  std::string interface;  ///< empty: no route at all
  bool is_up = false;
  bool does_multicast = false;
};
MulticastRoute FindMulticastRoute(const MulticastGroup& group);
Finding JudgeRoute(const MulticastGroup& group, const MulticastRoute& route);

/// net.core.rmem_max and rmem_default [bytes].
/// @param sysctl_file  The settings that we ship; empty if they are not found.
std::vector<Finding> JudgeReceiveBuffers(const std::string& lcm_url,
                                         std::optional<std::int64_t> largest_bytes,
                                         std::optional<std::int64_t> default_bytes,
                                         const std::string& sysctl_file);

/// Sends a few messages to itself, small ones and some as large as an uncompressed picture, and
/// looks whether they come back.
/// @param sysctl_file  As above.
Finding TryLoopback(const std::string& lcm_url, const std::string& sysctl_file);

/// The command that loads the settings of buffers that we ship.
std::string LoadSettingsCommand(const std::string& sysctl_file);

/// All of these, for this machine.
std::vector<Finding> CheckNetwork(const std::string& lcm_url);

}  // namespace fallen
