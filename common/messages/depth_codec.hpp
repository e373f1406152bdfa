// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/geometry/enum_names.hpp"

/// Lossless compression of depth images for the wire. Layouts and figures: lcmtypes/README.md.
namespace fallen {

/// As in depth_image_t.
enum class DepthCompression : std::int8_t {
  kNone = 0,
  kZlib = 1,
  kLz4 = 2,
  kDifferences = 3,
  kRanks = 4,
};
constexpr auto EnumNames(DepthCompression) {
  return EnumTable<DepthCompression, 5>{{{DepthCompression::kNone, "none"},
                                         {DepthCompression::kZlib, "zlib"},
                                         {DepthCompression::kLz4, "lz4"},
                                         {DepthCompression::kDifferences, "differences"},
                                         {DepthCompression::kRanks, "ranks"}}};
}

/// The smallest on every recording that was measured, at a millisecond or two an image.
inline constexpr DepthCompression kDefaultDepthCompression = DepthCompression::kRanks;

/// Most pixels that an image on the wire may have: a bound on what a message can make us allocate.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 24;

struct EncodedDepth {
  DepthCompression compression = kDefaultDepthCompression;
  std::vector<std::uint8_t> bytes;
};

/// Compresses `depth`, row-major, `width` values a row.
///
/// The result's compression is the one asked for, but for kRanks with more than 32767 distinct
/// values (no sensor has them): then it is kDifferences.
/// @throws std::invalid_argument unless `depth` is whole rows, at least one, and at most
/// kMaxPixels. Deterministic for one version of the compression libraries. Thread-safe.
EncodedDepth EncodeDepth(std::span<const std::uint16_t> depth, int width,
                         DepthCompression compression = kDefaultDepthCompression);

/// The image that `bytes` hold; exact.
/// @throws std::invalid_argument for anything but width * height values. What it allocates is
/// bounded by kMaxPixels, whatever the bytes say. Thread-safe.
std::vector<std::uint16_t> DecodeDepth(std::span<const std::uint8_t> bytes,
                                       DepthCompression compression, int width, int height);

}  // namespace fallen
