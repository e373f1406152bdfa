// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

/// What an LCM URL asks for, and whether this machine gives it.
namespace fallen {

/// Receive buffer that holds a burst of our largest messages [bytes]: 614 KB lost nothing with
/// 4 MB and everything with the system's default of 208 KB.
inline constexpr std::int64_t kMinReceiveBufferBytes = 2 * 1024 * 1024;

/// @throws std::invalid_argument for a URL of a kind that LCM does not have.
void RequireKnownLcmUrl(const std::string& url);

/// Receive buffer that a udpm URL asks for; 0 if it asks for none; nothing for another kind of URL.
std::optional<std::int64_t> ReceiveBufferOf(const std::string& url);

/// A warning if messages of ours will be lost on this URL, "" if not: the buffer that it asks for,
/// or the one that the system grants, is too small. Names what mends it.
/// @param system_limit_bytes  net.core.rmem_max; nothing if unknown.
std::string ReceiveBufferWarning(const std::string& url,
                                 std::optional<std::int64_t> system_limit_bytes);

/// net.core.rmem_max of this machine, if it can be read.
std::optional<std::int64_t> SystemReceiveBufferLimit();

}  // namespace fallen
