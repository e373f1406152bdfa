// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The compression libraries, with sizes checked before anything is allocated. Internal to this
/// folder.
///
/// Every decompression throws std::invalid_argument, naming `field`, unless the bytes are whole and
/// hold just what is expected. Deterministic for one version of the libraries. Thread-safe.
namespace fallen::codecs {

using Bytes = std::vector<std::uint8_t>;

Bytes Zstd(std::span<const std::uint8_t> raw, int level);
Bytes Zlib(std::span<const std::uint8_t> raw);
Bytes Lz4(std::span<const std::uint8_t> raw);

/// One zstd frame that says its size, which must be in [`min_size`, `max_size`].
Bytes UnZstd(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t min_size,
             std::size_t max_size);
/// One zlib stream of exactly `size` bytes.
Bytes UnZlib(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t size);
/// One LZ4 block of exactly `size` bytes.
Bytes UnLz4(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t size);

}  // namespace fallen::codecs
