// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "fallen/messages/log_file.hpp"
#include "fallen/messages/log_format.hpp"

namespace fallen {

struct LogWriter::State {
  std::filesystem::path path;
  std::FILE* file = nullptr;
  std::int64_t events = 0;

  ~State() {
    if (file != nullptr) std::fclose(file);
  }

  void Put(const void* bytes, std::size_t size) {
    if (size > 0 && std::fwrite(bytes, 1, size, file) != size) Throw("cannot write");
  }
  [[noreturn]] void Throw(const char* what) const {
    throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(errno));
  }
};

LogWriter::LogWriter(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->file = std::fopen(path.c_str(), "wb");
  if (state_->file == nullptr) state_->Throw("cannot create");
}

LogWriter::~LogWriter() = default;
LogWriter::LogWriter(LogWriter&&) noexcept = default;

void LogWriter::Write(std::int64_t utime, const std::string& channel,
                      const std::vector<std::uint8_t>& data) {
  using namespace log_format;
  if (state_->file == nullptr) throw std::logic_error(state_->path.string() + ": is closed");
  const auto channel_bytes = static_cast<std::int64_t>(channel.size());
  if (channel_bytes < 1 || channel_bytes > kMaxChannelBytes)
    throw std::invalid_argument("log event: channel: got " + std::to_string(channel_bytes) +
                                " characters, expected 1 to " + std::to_string(kMaxChannelBytes));
  if (static_cast<std::int64_t>(data.size()) > kMaxDataBytes)
    throw std::invalid_argument("log event: data: got " + std::to_string(data.size()) +
                                " bytes, expected at most " + std::to_string(kMaxDataBytes));
  std::array<std::uint8_t, kHeaderBytes> header{};
  WriteBigEndian(kSyncWord, &header[0]);
  WriteBigEndian(static_cast<std::uint64_t>(state_->events), &header[4]);
  WriteBigEndian(static_cast<std::uint64_t>(utime), &header[12]);
  WriteBigEndian(static_cast<std::uint32_t>(channel.size()), &header[20]);
  WriteBigEndian(static_cast<std::uint32_t>(data.size()), &header[24]);
  state_->Put(header.data(), header.size());
  state_->Put(channel.data(), channel.size());
  state_->Put(data.data(), data.size());
  ++state_->events;
}

void LogWriter::Close() {
  if (state_->file == nullptr) return;
  const int status = std::fclose(state_->file);
  state_->file = nullptr;
  if (status != 0) state_->Throw("cannot write");
}

}  // namespace fallen
