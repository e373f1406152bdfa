// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/alarm_output_config.hpp"

#include <stdexcept>

namespace fallen {
namespace {

/// A topic that names one place: no wildcards, no empty level at an end.
bool IsTopic(const std::string& topic) {
  return !topic.empty() && topic.find_first_of("+#") == std::string::npos && topic.front() != '/' &&
         topic.front() != '$' && topic.back() != '/';
}

}  // namespace

void MqttConfig::Validate() const {
  if (port < 1 || port > 65535)
    throw std::invalid_argument("mqtt: port is " + std::to_string(port) + ", must be 1 to 65535");
  if (!IsTopic(topic))
    throw std::invalid_argument("mqtt: topic is '" + topic +
                                "', must be a topic without + and #, and without / at its ends");
  if (!discovery_prefix.empty() && !IsTopic(discovery_prefix))
    throw std::invalid_argument("mqtt: discovery_prefix is '" + discovery_prefix +
                                "', must be empty or a topic without + and #");
  if (username.empty() && !password_file.empty())
    throw std::invalid_argument("mqtt: password_file is set, must go with a username");
}

}  // namespace fallen
