// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <span>
#include <stdexcept>
#include <system_error>

#include "fallen/messages/log_file.hpp"
#include "fallen/messages/log_format.hpp"

namespace fallen {
namespace {

using log_format::kHeaderBytes;
using log_format::kSyncBytes;

// Read at a time, at least: a few frames.
constexpr std::int64_t kWindowBytes = std::int64_t{1} << 20;

/// Any part of a file, through a buffer that holds the part asked for last.
class FileWindow {
 public:
  explicit FileWindow(const std::filesystem::path& path) {
    const auto fail = [&] {
      throw std::runtime_error(path.string() + ": cannot open: " + std::strerror(errno));
    };
    // A folder opens for reading, and only then fails.
    if (std::filesystem::is_directory(path)) errno = EISDIR, fail();
    file_ = std::fopen(path.c_str(), "rb");
    if (file_ == nullptr) fail();
    if (std::fseek(file_, 0, SEEK_END) != 0) fail();
    size_ = std::ftell(file_);
    if (size_ < 0) fail();
  }
  ~FileWindow() { std::fclose(file_); }
  FileWindow(const FileWindow&) = delete;
  FileWindow& operator=(const FileWindow&) = delete;

  std::int64_t size() const { return size_; }

  /// The bytes from `offset` on, at most `count`: fewer at the end of the file. Valid until the
  /// next call.
  std::span<const std::uint8_t> At(std::int64_t offset, std::int64_t count) {
    count = std::clamp<std::int64_t>(count, 0, std::max<std::int64_t>(0, size_ - offset));
    const std::int64_t end = begin_ + static_cast<std::int64_t>(buffer_.size());
    if (offset < begin_ || offset + count > end) Load(offset, std::max(count, kWindowBytes));
    const std::int64_t present = begin_ + static_cast<std::int64_t>(buffer_.size()) - offset;
    return {buffer_.data() + (offset - begin_),
            static_cast<std::size_t>(std::clamp<std::int64_t>(present, 0, count))};
  }

 private:
  // A file that shrinks or fails while it is read ends early.
  void Load(std::int64_t offset, std::int64_t count) {
    buffer_.resize(static_cast<std::size_t>(std::min(count, size_ - offset)));
    begin_ = offset;
    const bool is_there = std::fseek(file_, offset, SEEK_SET) == 0;
    const std::size_t got = is_there ? std::fread(buffer_.data(), 1, buffer_.size(), file_) : 0;
    if (got < buffer_.size()) {
      buffer_.resize(got);
      size_ = offset + static_cast<std::int64_t>(got);
    }
  }

  std::FILE* file_ = nullptr;
  std::int64_t size_ = 0;
  std::int64_t begin_ = 0;
  std::vector<std::uint8_t> buffer_;
};

/// What lies at an offset.
struct Candidate {
  std::string error;          ///< empty if there are a sync word and lengths that fit
  bool is_confirmed = false;  ///< and what follows is the next event, or the end
  std::int64_t event_number = 0;
  std::int64_t utime = 0;
  std::int64_t channel_bytes = 0;
  std::int64_t end = 0;
};

std::string Expectation(const char* what, std::int64_t got, std::int64_t low, std::int64_t high) {
  return std::string(what) + ": got " + std::to_string(got) + ", expected " + std::to_string(low) +
         " to " + std::to_string(high);
}

bool IsPrintable(std::span<const std::uint8_t> text) {
  return std::all_of(text.begin(), text.end(), [](std::uint8_t c) { return c > 0x20 && c < 0x7f; });
}

}  // namespace

struct LogReader::State {
  explicit State(const std::filesystem::path& path) : file(path) {}

  FileWindow file;
  std::int64_t position = 0;
  std::vector<LogDamage> damage;

  // Starts an event here, as far as its first bytes tell? The last bytes of a file may cut it off.
  bool MayStart(std::int64_t offset) {
    const auto bytes = file.At(offset, kSyncBytes);
    std::uint8_t sync[kSyncBytes];
    log_format::WriteBigEndian(log_format::kSyncWord, sync);
    return std::equal(bytes.begin(), bytes.end(), sync);
  }

  Candidate Examine(std::int64_t offset) {
    using namespace log_format;
    Candidate candidate;
    const auto header = file.At(offset, kHeaderBytes);
    if (!MayStart(offset)) {
      candidate.error = "no event starts here: expected the sync word 0xeda1da01";
      return candidate;
    }
    if (header.size() < kHeaderBytes) {
      candidate.error = "truncated: got " + std::to_string(header.size()) +
                        " bytes of an event, expected " + std::to_string(kHeaderBytes) + " or more";
      return candidate;
    }
    const std::uint8_t* const bytes = file.At(offset, kHeaderBytes).data();
    candidate.event_number = static_cast<std::int64_t>(ReadBigEndian<std::uint64_t>(bytes + 4));
    candidate.utime = static_cast<std::int64_t>(ReadBigEndian<std::uint64_t>(bytes + 12));
    candidate.channel_bytes = static_cast<std::int32_t>(ReadBigEndian<std::uint32_t>(bytes + 20));
    const std::int64_t data_bytes =
        static_cast<std::int32_t>(ReadBigEndian<std::uint32_t>(bytes + 24));
    if (candidate.channel_bytes < 1 || candidate.channel_bytes > kMaxChannelBytes) {
      candidate.error = Expectation("channel length", candidate.channel_bytes, 1, kMaxChannelBytes);
      return candidate;
    }
    if (data_bytes < 0 || data_bytes > kMaxDataBytes) {
      candidate.error = Expectation("data length", data_bytes, 0, kMaxDataBytes);
      return candidate;
    }
    candidate.end =
        offset + static_cast<std::int64_t>(kHeaderBytes) + candidate.channel_bytes + data_bytes;
    if (candidate.end > file.size()) {
      candidate.error = "truncated: got " + std::to_string(file.size() - offset) +
                        " bytes of an event, expected " + std::to_string(candidate.end - offset);
      return candidate;
    }
    if (!IsPrintable(
            file.At(offset + static_cast<std::int64_t>(kHeaderBytes), candidate.channel_bytes))) {
      candidate.error = "channel name: got unprintable characters, expected a name";
      return candidate;
    }
    candidate.is_confirmed = MayStart(candidate.end);  // also at the end of the file
    return candidate;
  }

  // First offset in [begin, end) at which a confirmed event starts, or `end`. A sync word inside a
  // payload does not count: what its lengths say is followed by no other.
  std::int64_t FindConfirmed(std::int64_t begin, std::int64_t end) {
    const std::uint8_t first = log_format::kSyncWord >> 24;
    while (begin < end) {
      const auto bytes = file.At(begin, std::min(end - begin, kWindowBytes));
      if (bytes.empty()) return end;
      const auto hit = std::find(bytes.begin(), bytes.end(), first);
      begin += hit - bytes.begin();
      if (hit == bytes.end()) continue;
      if (file.At(begin, kSyncBytes).size() == kSyncBytes && MayStart(begin)) {
        const Candidate candidate = Examine(begin);
        if (candidate.error.empty() && candidate.is_confirmed) return begin;
      }
      ++begin;
    }
    return end;
  }
};

LogReader::LogReader(const std::filesystem::path& path) : state_(std::make_unique<State>(path)) {}
LogReader::~LogReader() = default;
LogReader::LogReader(LogReader&&) noexcept = default;

std::optional<LogEvent> LogReader::Next() {
  State& state = *state_;
  while (state.position < state.file.size()) {
    const std::int64_t offset = state.position;
    const Candidate candidate = state.Examine(offset);
    const auto header_bytes = static_cast<std::int64_t>(kHeaderBytes);
    // With something else than an event after it, the event is whole and damage follows (none
    // starts before its end), or its lengths are wrong (one does).
    const std::int64_t next = candidate.error.empty() && !candidate.is_confirmed
                                  ? state.FindConfirmed(offset + 1, candidate.end)
                                  : candidate.end;
    if (!candidate.error.empty() || next < candidate.end) {
      const std::int64_t found =
          candidate.error.empty() ? next : state.FindConfirmed(offset + 1, state.file.size());
      const std::string reason =
          candidate.error.empty() ? "lengths reach into the next event" : candidate.error;
      state.damage.push_back({offset, found - offset, reason});
      state.position = found;
      continue;
    }
    LogEvent event{candidate.event_number, candidate.utime, {}, {}};
    const auto body = state.file.At(offset + header_bytes, candidate.end - offset - header_bytes);
    if (static_cast<std::int64_t>(body.size()) < candidate.end - offset - header_bytes) continue;
    event.channel.assign(body.begin(), body.begin() + candidate.channel_bytes);
    event.data.assign(body.begin() + candidate.channel_bytes, body.end());
    state.position = candidate.end;
    return event;
  }
  return std::nullopt;
}

const std::vector<LogDamage>& LogReader::damage() const { return state_->damage; }
std::int64_t LogReader::size_bytes() const { return state_->file.size(); }
std::int64_t LogReader::position_bytes() const { return state_->position; }

}  // namespace fallen
