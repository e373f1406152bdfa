// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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

std::vector<std::uint8_t> EncodeLogEvent(const LogEvent& event) {
  using namespace log_format;
  const auto channel_bytes = static_cast<std::int64_t>(event.channel.size());
  if (channel_bytes < 1 || channel_bytes > kMaxChannelBytes)
    throw std::invalid_argument("log event: channel: got " + std::to_string(channel_bytes) +
                                " characters, expected 1 to " + std::to_string(kMaxChannelBytes));
  if (static_cast<std::int64_t>(event.data.size()) > kMaxDataBytes)
    throw std::invalid_argument("log event: data: got " + std::to_string(event.data.size()) +
                                " bytes, expected at most " + std::to_string(kMaxDataBytes));
  std::vector<std::uint8_t> bytes(kHeaderBytes + event.channel.size() + event.data.size());
  WriteBigEndian(kSyncWord, &bytes[0]);
  WriteBigEndian(static_cast<std::uint64_t>(event.number), &bytes[4]);
  WriteBigEndian(static_cast<std::uint64_t>(event.utime), &bytes[12]);
  WriteBigEndian(static_cast<std::uint32_t>(event.channel.size()), &bytes[20]);
  WriteBigEndian(static_cast<std::uint32_t>(event.data.size()), &bytes[24]);
  const auto data =
      std::copy(event.channel.begin(), event.channel.end(), bytes.begin() + kHeaderBytes);
  std::copy(event.data.begin(), event.data.end(), data);
  return bytes;
}

void LogWriter::Write(std::int64_t utime, const std::string& channel,
                      const std::vector<std::uint8_t>& data) {
  if (state_->file == nullptr) throw std::logic_error(state_->path.string() + ": is closed");
  const auto bytes = EncodeLogEvent({state_->events, utime, channel, data});
  state_->Put(bytes.data(), bytes.size());
  ++state_->events;
}

void LogWriter::Close() {
  if (state_->file == nullptr) return;
  const int status = std::fclose(state_->file);
  state_->file = nullptr;
  if (status != 0) state_->Throw("cannot write");
}

}  // namespace fallen
