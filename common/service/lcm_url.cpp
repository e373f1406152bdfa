// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/lcm_url.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace fallen {

void RequireKnownLcmUrl(const std::string& url) {
  for (const char* kind : {"udpm://", "tcpq://", "memq://", "file://"})
    if (url.rfind(kind, 0) == 0) return;
  throw std::invalid_argument("LCM URL: got '" + url +
                              "', expected udpm://, tcpq://, memq:// or file://");
}

std::optional<std::int64_t> ReceiveBufferOf(const std::string& url) {
  if (url.rfind("udpm://", 0) != 0) return std::nullopt;
  static constexpr char kKey[] = "recv_buf_size=";
  const std::size_t at = url.find(kKey);
  if (at == std::string::npos) return 0;
  return std::strtoll(url.c_str() + at + sizeof kKey - 1, nullptr, 10);
}

std::string ReceiveBufferWarning(const std::string& url,
                                 std::optional<std::int64_t> system_limit_bytes) {
  const std::optional<std::int64_t> wanted = ReceiveBufferOf(url);
  if (!wanted) return "";
  const std::string least = std::to_string(kMinReceiveBufferBytes);
  if (*wanted < kMinReceiveBufferBytes)
    return "LCM URL asks for a receive buffer of " + std::to_string(*wanted) +
           " bytes, large messages will be lost: add recv_buf_size=4194304 to it";
  if (system_limit_bytes && *system_limit_bytes < kMinReceiveBufferBytes)
    return "net.core.rmem_max is " + std::to_string(*system_limit_bytes) + ", needs " + least +
           " or more, large messages will be lost: run sysctl -w net.core.rmem_max=4194304";
  return "";
}

std::optional<std::int64_t> SystemReceiveBufferLimit() {
  std::ifstream file("/proc/sys/net/core/rmem_max");
  std::int64_t bytes = 0;
  if (!(file >> bytes)) return std::nullopt;
  return bytes;
}

}  // namespace fallen
