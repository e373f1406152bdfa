// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/byte_compression.hpp"

#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "fallen/messages/message_checks.hpp"

namespace fallen::codecs {
namespace {

// Speed counts: level 6 takes four times as long for a quarter less on depth images.
constexpr int kZlibLevel = 1;
// What the formats can shrink at most (zlib.net/zlib_tech.html; LZ4's run lengths): a message that
// claims more is refused before the memory for it is there.
constexpr std::size_t kZlibMaxRatio = 1032;
constexpr std::size_t kLz4MaxRatio = 255;
constexpr std::size_t kRatioSlackBytes = 64;

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

// A context is a megabyte to allocate: kept for the thread's next image.
ZSTD_CCtx& CompressionContext() {
  thread_local const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  if (!context) throw std::bad_alloc();
  return *context;
}

ZSTD_DCtx& DecompressionContext() {
  thread_local const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
  if (!context) throw std::bad_alloc();
  return *context;
}

void CheckRatio(std::string_view field, std::size_t compressed, std::size_t raw,
                std::size_t max_ratio) {
  if (raw / max_ratio > compressed + kRatioSlackBytes)
    checks::Fail(field, std::to_string(compressed) + " bytes",
                 "what can hold " + std::to_string(raw) + " bytes");
}

int IntSize(std::size_t size) {
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::invalid_argument("compression: got " + std::to_string(size) +
                                " bytes, expected less than 2 GB");
  return static_cast<int>(size);
}

}  // namespace

Bytes Zstd(std::span<const std::uint8_t> raw, int level) {
  Bytes bytes(ZSTD_compressBound(raw.size()));
  const std::size_t size = ZSTD_compressCCtx(&CompressionContext(), bytes.data(), bytes.size(),
                                             raw.data(), raw.size(), level);
  if (ZSTD_isError(size)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  bytes.resize(size);
  return bytes;
}

Bytes Zlib(std::span<const std::uint8_t> raw) {
  uLongf size = compressBound(raw.size());
  Bytes bytes(size);
  const int status = compress2(bytes.data(), &size, raw.data(), raw.size(), kZlibLevel);
  if (status != Z_OK) throw std::runtime_error(std::string("zlib: ") + zError(status));
  bytes.resize(size);
  return bytes;
}

Bytes Lz4(std::span<const std::uint8_t> raw) {
  Bytes bytes(static_cast<std::size_t>(LZ4_compressBound(IntSize(raw.size()))));
  const int size = LZ4_compress_default(reinterpret_cast<const char*>(raw.data()),
                                        reinterpret_cast<char*>(bytes.data()), IntSize(raw.size()),
                                        IntSize(bytes.size()));
  if (size <= 0) throw std::runtime_error("lz4: compression failed");
  bytes.resize(static_cast<std::size_t>(size));
  return bytes;
}

Bytes UnZstd(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t min_size,
             std::size_t max_size) {
  const unsigned long long claimed = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (claimed == ZSTD_CONTENTSIZE_ERROR || claimed == ZSTD_CONTENTSIZE_UNKNOWN)
    checks::Fail(field, "bytes that do not start a zstd frame with its size", "a zstd frame");
  if (claimed < min_size || claimed > max_size)
    checks::Fail(field, "a zstd frame of " + std::to_string(claimed) + " bytes",
                 min_size == max_size
                     ? std::to_string(min_size)
                     : std::to_string(min_size) + " to " + std::to_string(max_size));
  const std::size_t frame_size = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
  if (ZSTD_isError(frame_size) || frame_size != bytes.size())
    checks::Fail(field, std::to_string(bytes.size()) + " bytes that are not one whole zstd frame",
                 "one zstd frame and nothing else");
  Bytes raw(static_cast<std::size_t>(claimed));
  const std::size_t size = ZSTD_decompressDCtx(&DecompressionContext(), raw.data(), raw.size(),
                                               bytes.data(), bytes.size());
  if (ZSTD_isError(size))
    checks::Fail(field, std::string("a damaged zstd frame (") + ZSTD_getErrorName(size) + ")",
                 "a whole one");
  if (size != raw.size())
    checks::Fail(field, "a zstd frame of " + std::to_string(size) + " bytes",
                 std::to_string(raw.size()));
  return raw;
}

Bytes UnZlib(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t size) {
  CheckRatio(field, bytes.size(), size, kZlibMaxRatio);
  Bytes raw(size);
  uLongf raw_size = size;
  uLong consumed = bytes.size();
  const int status = uncompress2(raw.data(), &raw_size, bytes.data(), &consumed);
  if (status != Z_OK)
    checks::Fail(field, std::string("no zlib stream of the right size (") + zError(status) + ")",
                 std::to_string(size) + " bytes in a zlib stream");
  if (raw_size != size || consumed != bytes.size())
    checks::Fail(field,
                 "a zlib stream of " + std::to_string(raw_size) + " bytes in " +
                     std::to_string(consumed) + " of " + std::to_string(bytes.size()),
                 std::to_string(size) + " bytes and nothing after them");
  return raw;
}

Bytes UnLz4(std::string_view field, std::span<const std::uint8_t> bytes, std::size_t size) {
  CheckRatio(field, bytes.size(), size, kLz4MaxRatio);
  Bytes raw(size);
  const int got = LZ4_decompress_safe(reinterpret_cast<const char*>(bytes.data()),
                                      reinterpret_cast<char*>(raw.data()), IntSize(bytes.size()),
                                      IntSize(raw.size()));
  if (got < 0) checks::Fail(field, "a damaged LZ4 block", "a whole one");
  if (static_cast<std::size_t>(got) != size)
    checks::Fail(field, "an LZ4 block of " + std::to_string(got) + " bytes", std::to_string(size));
  return raw;
}

}  // namespace fallen::codecs
