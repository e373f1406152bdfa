// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/channels.hpp"

#include <cctype>

namespace fallen::channels {

std::string Status(const std::string& service) {
  std::string channel = "STATUS_";
  for (const char c : service)
    channel += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return channel;
}

bool IsValidCamera(const std::string& camera) {
  if (camera.empty() || camera.size() > kMaxCameraLength) return false;
  for (const char c : camera)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') return false;
  return true;
}

}  // namespace fallen::channels
