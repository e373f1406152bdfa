// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// LCM event logs without the LCM library: sequential reading that survives damage, and writing.
namespace fallen {

struct LogEvent {
  std::int64_t number = 0;
  std::int64_t utime = 0;  ///< time of logging [us]
  std::string channel;
  std::vector<std::uint8_t> data;
};

/// A place in the log that could not be read, and how far the reader had to go on.
struct LogDamage {
  std::int64_t offset = 0;         ///< of the first bad byte
  std::int64_t skipped_bytes = 0;  ///< until the next event, or the end
  std::string reason;
};

/// Reads events in order; resynchronises on the next plausible event after damage.
class LogReader {
 public:
  /// @throws std::runtime_error if the file cannot be opened.
  explicit LogReader(const std::filesystem::path& path);
  ~LogReader();
  LogReader(LogReader&&) noexcept;

  /// Next event; nothing at the end. Never throws for what the file holds.
  std::optional<LogEvent> Next();

  const std::vector<LogDamage>& damage() const;
  std::int64_t size_bytes() const;
  std::int64_t position_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Bytes of an event as they stand in a log: a log is nothing but its events.
/// @throws std::invalid_argument for a channel or data that LCM has no room for.
std::vector<std::uint8_t> EncodeLogEvent(const LogEvent& event);

/// Writes events; numbers them. @throws std::runtime_error on any failure to write.
class LogWriter {
 public:
  explicit LogWriter(const std::filesystem::path& path);
  ~LogWriter();
  LogWriter(LogWriter&&) noexcept;

  void Write(std::int64_t utime, const std::string& channel, const std::vector<std::uint8_t>& data);
  /// Flushes and reports what the destructor could not.
  void Close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Bytes of a message, for LogWriter and for publishing. The message's counts must be the sizes of
/// its arrays, as ToMessage makes them: the generated code does not check.
/// Instantiated for every type in lcmtypes/ that travels alone or in a file.
/// @throws std::invalid_argument if it cannot be encoded.
template <class Message>
std::vector<std::uint8_t> EncodeMessage(const Message& message);

}  // namespace fallen
