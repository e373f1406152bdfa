// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/container_file.hpp"

#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "fallen/messages/byte_compression.hpp"
#include "fallen/messages/log_format.hpp"

namespace fallen {
namespace {

using log_format::ReadBigEndian;
using log_format::WriteBigEndian;

constexpr std::size_t kVersionOffset = 8;
constexpr std::size_t kChecksumOffset = 12;
constexpr std::size_t kLengthOffset = 16;
constexpr std::size_t kHeaderBytes = 24;
// zstd's default: a map of a million cells in a third of a second.
constexpr int kZstdLevel = 3;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}
[[noreturn]] void FailErrno(const std::filesystem::path& path, const std::string& what) {
  Fail(path, what + ": " + std::strerror(errno));
}
[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& place,
                       const std::string& got, const std::string& expected) {
  Fail(path, place + ": got " + got + ", expected " + expected);
}

std::string Hex(std::uint32_t value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%08x", value);
  return text.data();
}

std::string Printable(std::span<const std::uint8_t> bytes) {
  std::string text = "\"";
  for (const std::uint8_t byte : bytes)
    text += byte >= 0x20 && byte < 0x7f ? static_cast<char>(byte) : '.';
  return text + "\"";
}

std::uint32_t Checksum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

std::vector<std::uint8_t> ReadFile(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) errno = EISDIR, FailErrno(path, "cannot open");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) FailErrno(path, "cannot open");
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 1 << 16> chunk;
  while (const std::size_t size = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(size));
    if (bytes.size() > static_cast<std::size_t>(log_format::kMaxDataBytes))
      Fail(path, "size", "more than " + std::to_string(log_format::kMaxDataBytes) + " bytes",
           "less");
  }
  if (std::ferror(file.get()) != 0) FailErrno(path, "cannot read");
  return bytes;
}

void CheckHeader(const std::filesystem::path& path, const ContainerKind& kind,
                 std::span<const std::uint8_t> bytes) {
  const auto magic = bytes.first(std::min(bytes.size(), kind.magic.size()));
  if (!std::equal(magic.begin(), magic.end(), kind.magic.begin(), kind.magic.end()))
    Fail(path, "first bytes", Printable(magic),
         "\"" + std::string(kind.magic) + "\" of " + std::string(kind.name));
  if (bytes.size() < kHeaderBytes)
    Fail(path, "size", std::to_string(bytes.size()) + " bytes",
         std::to_string(kHeaderBytes) + " or more");
  const auto version = ReadBigEndian<std::uint32_t>(&bytes[kVersionOffset]);
  if (version != kind.version)
    Fail(path, "version", std::to_string(version), std::to_string(kind.version));
  const auto length = ReadBigEndian<std::uint64_t>(&bytes[kLengthOffset]);
  if (length != bytes.size() - kHeaderBytes)
    Fail(path, "size", std::to_string(bytes.size()) + " bytes",
         std::to_string(kHeaderBytes) + " + " + std::to_string(length));
  const auto expected = ReadBigEndian<std::uint32_t>(&bytes[kChecksumOffset]);
  const auto got = Checksum(bytes.subspan(kLengthOffset));
  if (got != expected) Fail(path, "check sum", Hex(got), Hex(expected) + ": the file is damaged");
}

}  // namespace

std::vector<std::uint8_t> ReadContainer(const std::filesystem::path& path,
                                        const ContainerKind& kind) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  CheckHeader(path, kind, bytes);
  try {
    return codecs::UnZstd("payload", std::span(bytes).subspan(kHeaderBytes), 0,
                          static_cast<std::size_t>(log_format::kMaxDataBytes));
  } catch (const std::invalid_argument& error) {
    Fail(path, error.what());
  }
}

void WriteContainer(const std::filesystem::path& path, const ContainerKind& kind,
                    std::span<const std::uint8_t> content) {
  const std::vector<std::uint8_t> payload = codecs::Zstd(content, kZstdLevel);
  std::vector<std::uint8_t> bytes(kHeaderBytes);
  std::copy(kind.magic.begin(), kind.magic.end(), bytes.begin());
  WriteBigEndian(kind.version, &bytes[kVersionOffset]);
  WriteBigEndian(static_cast<std::uint64_t>(payload.size()), &bytes[kLengthOffset]);
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  WriteBigEndian(Checksum(std::span(bytes).subspan(kLengthOffset)), &bytes[kChecksumOffset]);

  std::filesystem::path part = path;
  part += ".part" + std::to_string(::getpid());
  File file(std::fopen(part.c_str(), "wb"));
  if (!file) FailErrno(path, "cannot create");
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                          std::fflush(file.get()) == 0 && ::fsync(::fileno(file.get())) == 0;
  file.reset();
  if (is_written && std::rename(part.c_str(), path.c_str()) == 0) return;
  const int error = errno;
  std::remove(part.c_str());
  errno = error;
  FailErrno(path, "cannot write");
}

}  // namespace fallen
