// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

/// Layout of an LCM event log: events one after the other, all numbers big-endian. Internal.
///
/// sync word (4), event number (8), time [us] (8), channel length (4), data length (4), channel,
/// data.
namespace fallen::log_format {

inline constexpr std::uint32_t kSyncWord = 0xEDA1DA01;
inline constexpr std::size_t kSyncBytes = 4;
inline constexpr std::size_t kHeaderBytes = 28;
/// LCM_MAX_CHANNEL_NAME_LENGTH: LCM publishes nothing on a longer one.
inline constexpr std::int64_t kMaxChannelBytes = 63;
/// Far beyond what travels (a depth image is 0.6 MB at most); bounds the damage a bad length does.
inline constexpr std::int64_t kMaxDataBytes = std::int64_t{1} << 28;

/// Big-endian unsigned number of sizeof(T) bytes at `bytes`.
template <class T>
T ReadBigEndian(const std::uint8_t* bytes) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) value = static_cast<T>((value << 8) | bytes[i]);
  return value;
}

template <class T>
void WriteBigEndian(T value, std::uint8_t* bytes) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes[i] = static_cast<std::uint8_t>(value >> (8 * (sizeof(T) - 1 - i)));
}

}  // namespace fallen::log_format
