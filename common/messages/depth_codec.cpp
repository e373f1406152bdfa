// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/depth_codec.hpp"

#include <string>

#include "fallen/messages/byte_compression.hpp"
#include "fallen/messages/depth_filters.hpp"
#include "fallen/messages/message_checks.hpp"

namespace fallen {
namespace {

constexpr char kField[] = "depth_image_t.data";
// Level 3 saves 2 % and takes up to 70 % longer.
constexpr int kZstdLevel = 1;

std::vector<std::uint8_t> LittleEndian(std::span<const std::uint16_t> depth) {
  std::vector<std::uint8_t> bytes(2 * depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    bytes[2 * i] = static_cast<std::uint8_t>(depth[i]);
    bytes[2 * i + 1] = static_cast<std::uint8_t>(depth[i] >> 8);
  }
  return bytes;
}

std::vector<std::uint16_t> FromLittleEndian(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint16_t> depth(bytes.size() / 2);
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth[i] = static_cast<std::uint16_t>(bytes[2 * i] | (bytes[2 * i + 1] << 8));
  return depth;
}

void CheckSize(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > kMaxPixels || height > kMaxPixels / width)
    checks::Fail("depth_image_t.width x height",
                 std::to_string(width) + " x " + std::to_string(height),
                 "1 to " + std::to_string(kMaxPixels) + " pixels");
}

}  // namespace

EncodedDepth EncodeDepth(std::span<const std::uint16_t> depth, int width,
                         DepthCompression compression) {
  if (width < 1 || depth.size() % static_cast<std::size_t>(width) != 0)
    checks::Fail("depth_image_t.data", std::to_string(depth.size()) + " values",
                 "whole rows of " + std::to_string(width));
  CheckSize(width, static_cast<std::int64_t>(depth.size()) / width);
  switch (compression) {
    case DepthCompression::kNone:
      return {compression, LittleEndian(depth)};
    case DepthCompression::kZlib:
      return {compression, codecs::Zlib(LittleEndian(depth))};
    case DepthCompression::kLz4:
      return {compression, codecs::Lz4(LittleEndian(depth))};
    case DepthCompression::kDifferences:
      return {compression, codecs::Zstd(depth_filters::Differences(depth, width), kZstdLevel)};
    case DepthCompression::kRanks:
      if (const auto ranks = depth_filters::Ranks(depth, width))
        return {compression, codecs::Zstd(*ranks, kZstdLevel)};
      return EncodeDepth(depth, width, DepthCompression::kDifferences);
  }
  checks::Fail("depth_image_t.compression", std::to_string(static_cast<int>(compression)),
               "0 to 4");
}

std::vector<std::uint16_t> DecodeDepth(std::span<const std::uint8_t> bytes,
                                       DepthCompression compression, int width, int height) {
  CheckSize(width, height);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t raw_size = 2 * pixels;
  switch (compression) {
    case DepthCompression::kNone:
      if (bytes.size() != raw_size)
        checks::Fail(kField, std::to_string(bytes.size()) + " bytes", std::to_string(raw_size));
      return FromLittleEndian(bytes);
    case DepthCompression::kZlib:
      return FromLittleEndian(codecs::UnZlib(kField, bytes, raw_size));
    case DepthCompression::kLz4:
      return FromLittleEndian(codecs::UnLz4(kField, bytes, raw_size));
    case DepthCompression::kDifferences:
      return depth_filters::UndoDifferences(codecs::UnZstd(kField, bytes, raw_size, raw_size),
                                            width);
    case DepthCompression::kRanks:
      return depth_filters::UndoRanks(
          codecs::UnZstd(kField, bytes, depth_filters::MinRanksSize(pixels),
                         depth_filters::MaxRanksSize(pixels)),
          width, pixels);
  }
  checks::Fail("depth_image_t.compression", std::to_string(static_cast<int>(compression)),
               "0 to 4");
}

}  // namespace fallen
