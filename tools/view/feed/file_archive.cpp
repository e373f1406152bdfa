// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/file_archive.hpp"

#include <stdlib.h>
#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr int kLevel = 1;  // the fastest: a frame shrinks to a third in a millisecond

[[noreturn]] void Fail(const std::filesystem::path& folder, const std::string& what) {
  throw std::runtime_error(folder.string() + ": frames cannot be kept here: " + what);
}

}  // namespace

FileArchive::FileArchive(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / "fallen-view-XXXXXX").string();
  file_ = mkstemp(name.data());
  if (file_ < 0) Fail(folder_, std::strerror(errno));
  unlink(name.c_str());
}

FileArchive::~FileArchive() { close(file_); }

void FileArchive::Append(std::shared_ptr<const Bytes> frame) {
  Bytes compressed(ZSTD_compressBound(frame->size()));
  const std::size_t size =
      ZSTD_compress(compressed.data(), compressed.size(), frame->data(), frame->size(), kLevel);
  if (ZSTD_isError(size)) Fail(folder_, ZSTD_getErrorName(size));
  if (pwrite(file_, compressed.data(), size, end_) != static_cast<ssize_t>(size))
    Fail(folder_, std::strerror(errno));
  places_.push_back({end_, size, frame->size()});
  end_ += static_cast<std::int64_t>(size);
}

std::shared_ptr<const FileArchive::Bytes> FileArchive::Read(std::int64_t index) {
  const Place& place = places_.at(static_cast<std::size_t>(index));
  Bytes compressed(place.compressed_bytes);
  if (pread(file_, compressed.data(), compressed.size(), place.offset) !=
      static_cast<ssize_t>(compressed.size()))
    Fail(folder_, "frame " + std::to_string(index) + " cannot be read back");
  auto frame = std::make_shared<Bytes>(place.bytes);
  const std::size_t size =
      ZSTD_decompress(frame->data(), frame->size(), compressed.data(), compressed.size());
  if (size != place.bytes) Fail(folder_, "frame " + std::to_string(index) + " is damaged");
  return frame;
}

}  // namespace fallen
