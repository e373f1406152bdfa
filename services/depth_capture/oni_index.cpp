// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/oni_index.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// All from DataRecords.h; numbers are little-endian and packed.
constexpr std::size_t kFileHeaderBytes = 24;  // "NI10", version, max time, max node
constexpr std::uint32_t kRecordMagic = 0x0052494E;
constexpr std::uint32_t kNodeAddedOldest = 0x02;  // of file version 1.0.0.4
constexpr std::uint32_t kNodeAddedOld = 0x0C;     // of file version 1.0.0.5
constexpr std::uint32_t kNodeAdded = 0x0D;
constexpr std::uint32_t kFirstProperty = 0x03;  // of numbers, texts and structs
constexpr std::uint32_t kLastProperty = 0x06;
constexpr std::uint32_t kNewData = 0x0A;
constexpr std::uint32_t kEnd = 0x0B;
constexpr std::uint32_t kLastType = 0x0E;
constexpr std::uint32_t kDepthNode = 2;        // XN_NODE_TYPE_DEPTH
constexpr std::size_t kShortHeaderBytes = 24;  // with a 32-bit undo position
constexpr std::size_t kLongHeaderBytes = 28;   // with a 64-bit one, since 1.0.1.0
/// The player's buffer: a picture of 1600 x 1200 with 3 bytes a pixel.
constexpr std::uint32_t kMaxRecordBytes = 1600 * 1200 * 3;
constexpr std::uint32_t kMaxNameBytes = 80;  // XN_MAX_NAME_LENGTH
constexpr std::uint32_t kMaxSide = 8192;     // as CameraIntrinsics
/// Seek tables are the one kind of record that the player never loads into that buffer.
constexpr std::uint32_t kSeekTable = 0x0E;

template <class Number>
Number Get(const std::uint8_t* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

/// Position of version a.b.c.d in their order.
constexpr std::uint64_t Order(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  return (a << 56) | (b << 48) | (c << 32) | d;
}

struct Record {
  std::uint32_t type = 0;
  std::uint32_t node = 0;
  std::uint32_t fields_bytes = 0;  // without the header
  std::uint32_t payload_bytes = 0;
};

class Walker {
 public:
  explicit Walker(const std::filesystem::path& path)
      : name_(path.string()), file_(path, std::ios::binary) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || !file_)
      throw std::runtime_error(name_ + ": cannot be read, expected an .oni file");
    size_ = std::filesystem::file_size(path);
  }

  void ReadFileHeader() {
    std::array<std::uint8_t, kFileHeaderBytes> header{};
    Read(header.data(), header.size());
    if (std::memcmp(header.data(), "NI10", 4) != 0)
      Refuse(0, "got no .oni recording, expected one that starts with NI10");
    const std::uint64_t version =
        Order(header[4], header[5], Get<std::uint16_t>(&header[6]), Get<std::uint32_t>(&header[8]));
    if (version < Order(1, 0, 0, 4) || version > Order(1, 0, 1, 0))
      Refuse(4, "got version " + std::to_string(header[4]) + "." + std::to_string(header[5]) + "." +
                    std::to_string(Get<std::uint16_t>(&header[6])) + "." +
                    std::to_string(Get<std::uint32_t>(&header[8])) +
                    ", expected 1.0.0.4 to 1.0.1.0");
    header_bytes_ = version < Order(1, 0, 1, 0) ? kShortHeaderBytes : kLongHeaderBytes;
    // Of a recording that was not closed this still holds the placeholder, but no records may
    // follow.
    max_node_ = Get<std::uint32_t>(&header[20]);
  }

  Record ReadRecord() {
    start_ = position_;
    std::array<std::uint8_t, kLongHeaderBytes> header{};
    Read(header.data(), header_bytes_);
    if (Get<std::uint32_t>(&header[0]) != kRecordMagic) Refuse(start_, "got no record");
    Record record;
    record.type = Get<std::uint32_t>(&header[4]);
    record.node = Get<std::uint32_t>(&header[8]);
    const auto fields_and_header = Get<std::uint32_t>(&header[12]);
    record.payload_bytes = Get<std::uint32_t>(&header[16]);
    if (record.type < kNodeAddedOldest || record.type > kLastType)
      Refuse(start_, "got record type " + std::to_string(record.type) + ", expected 2 to 14");
    if (record.type != kEnd && record.node > max_node_)
      Refuse(start_, "got node " + std::to_string(record.node) + ", expected at most " +
                         std::to_string(max_node_));
    if (fields_and_header < header_bytes_ || fields_and_header > kMaxRecordBytes ||
        (record.type != kSeekTable && record.payload_bytes > kMaxRecordBytes - fields_and_header))
      Refuse(start_, "got a record of " + std::to_string(fields_and_header) + " + " +
                         std::to_string(record.payload_bytes) + " bytes, expected at most " +
                         std::to_string(kMaxRecordBytes));
    record.fields_bytes = fields_and_header - static_cast<std::uint32_t>(header_bytes_);
    end_ = start_ + fields_and_header + record.payload_bytes;
    if (end_ > size_)
      Refuse(size_, "the file ends within a record of " + std::to_string(end_ - start_) +
                        " bytes, expected a whole one (was the recording cut off?)");
    return record;
  }

  /// The first `Bytes` bytes of the fields of `record`.
  template <std::size_t Bytes>
  std::array<std::uint8_t, Bytes> ReadFields(const Record& record) {
    if (record.fields_bytes < Bytes)
      Refuse(start_, "got fields of " + std::to_string(record.fields_bytes) + " bytes, expected " +
                         std::to_string(Bytes));
    std::array<std::uint8_t, Bytes> fields{};
    Read(fields.data(), Bytes);
    return fields;
  }

  /// Type of the node that `record` adds: behind its name.
  std::uint32_t ReadNodeType(const Record& record) {
    ReadName(record);
    std::array<std::uint8_t, 4> type{};
    Read(type.data(), type.size());
    return Get<std::uint32_t>(type.data());
  }

  /// Refuses a property that would crash the player.
  void CheckProperty(const Record& record) {
    const std::string name = ReadName(record);
    std::array<std::uint8_t, 4> size{};
    Read(size.data(), size.size());
    const auto bytes = Get<std::uint32_t>(size.data());
    if (bytes != end_ - position_ || record.payload_bytes != 0)
      Refuse(start_, "got " + name + " of " + std::to_string(bytes) + " bytes, expected " +
                         std::to_string(end_ - position_));
    if (name == "oniRequiredFrameSize" || name == "RequiredDataSize")
      CheckNumber<std::uint64_t>(name, kMaxRecordBytes);
    if (name == "xnMapOutputMode") {  // width, height, rate
      CheckNumber<std::uint32_t>(name, kMaxSide);
      CheckNumber<std::uint32_t>(name, kMaxSide);
    }
  }

  void SkipRest() { Seek(end_); }

  /// Where the record at hand ends.
  std::uint64_t record_end() const { return end_; }

  [[noreturn]] void Refuse(std::uint64_t place, const std::string& text) const {
    throw std::runtime_error(name_ + ": byte " + std::to_string(place) + ": " + text);
  }

 private:
  /// The name that a record's fields begin with, and its last four bytes must not be a part of.
  ///
  /// The player takes the characters of a name as numbers, negative ones too, that it looks up.
  std::string ReadName(const Record& record) {
    const auto bytes = Get<std::uint32_t>(ReadFields<4>(record).data());
    if (bytes < 1 || bytes > kMaxNameBytes || record.fields_bytes < 8 + bytes)
      Refuse(start_, "got a name of " + std::to_string(bytes) + " bytes in fields of " +
                         std::to_string(record.fields_bytes));
    std::string name(bytes, '\0');
    Read(reinterpret_cast<std::uint8_t*>(name.data()), bytes);
    const bool ends_well = name.back() == '\0';
    name.pop_back();
    const bool is_plain =
        std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; });
    if (!ends_well || !is_plain) Refuse(start_, "got a name that is no plain word");
    return name;
  }

  template <class Number>
  void CheckNumber(const std::string& name, std::uint64_t largest) {
    std::array<std::uint8_t, sizeof(Number)> bytes{};
    Read(bytes.data(), bytes.size());
    const auto value = Get<Number>(bytes.data());
    if (position_ > end_ || value > largest)
      Refuse(start_, "got " + name + " " + std::to_string(value) + ", expected at most " +
                         std::to_string(largest));
  }

  void Seek(std::uint64_t position) {
    file_.seekg(static_cast<std::streamoff>(position));
    position_ = position;
  }

  void Read(std::uint8_t* bytes, std::size_t count) {
    file_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (!file_)
      Refuse(size_,
             "the file ends, expected more records and an end mark (was the recording cut off?)");
    position_ += count;
  }

  std::string name_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::uint64_t start_ = 0;  // of the record at hand
  std::uint64_t end_ = 0;
  std::size_t header_bytes_ = kLongHeaderBytes;
  std::uint32_t max_node_ = 0;
};

bool IsProperty(const Record& record) {
  return record.type >= kFirstProperty && record.type <= kLastProperty;
}

bool AddsNode(const Record& record) {
  return record.type == kNodeAdded || record.type == kNodeAddedOld ||
         record.type == kNodeAddedOldest;
}

}  // namespace

OniIndex IndexOniFile(const std::filesystem::path& path) {
  Walker walker(path);
  walker.ReadFileHeader();
  std::optional<std::uint32_t> depth_node;  // the first one is what the player plays
  OniIndex index;
  for (;;) {
    const Record record = walker.ReadRecord();
    if (record.type == kEnd) break;
    if (AddsNode(record) && walker.ReadNodeType(record) == kDepthNode && !depth_node)
      depth_node = record.node;
    if (IsProperty(record)) walker.CheckProperty(record);
    if (record.type == kNewData && record.node == depth_node) {
      const auto fields = walker.ReadFields<12>(record);
      const OniIndexEntry entry{static_cast<std::int64_t>(Get<std::uint64_t>(&fields[0])),
                                static_cast<std::int64_t>(Get<std::uint32_t>(&fields[8]))};
      // The player takes this pair for the mark of a failed seek and passes over it.
      if (entry != OniIndexEntry{}) index.frames.push_back(entry);
    }
    walker.SkipRest();
  }
  if (!depth_node) walker.Refuse(0, "got a recording without depth, expected a depth stream");
  if (index.frames.empty())
    walker.Refuse(0, "got a recording without frames, expected at least one");
  index.bytes = walker.record_end();
  return index;
}

}  // namespace fallen
