// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/oni_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include "tests/services/depth_capture/virtual_camera_control.hpp"

namespace fallen {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Writes recordings byte by byte, after DataRecords.h, good and bad.
class OniWriter {
 public:
  explicit OniWriter(bool long_headers = true) : long_headers_(long_headers) {
    bytes_ = "NI10";
    bytes_ += std::string("\1\0", 2);
    Add(std::uint16_t{static_cast<std::uint16_t>(long_headers ? 1 : 0)});
    Add(std::uint32_t{long_headers ? 0U : 5U});  // 1.0.1.0 or 1.0.0.5
    Add(std::uint64_t{1000});
    Add(std::uint32_t{2});  // highest node
  }

  template <class Number>
  OniWriter& Add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
    return *this;
  }

  OniWriter& AddHeader(std::uint32_t type, std::uint32_t node, std::uint32_t fields,
                       std::uint32_t payload) {
    Add(std::uint32_t{0x0052494E}).Add(type).Add(node);
    Add(static_cast<std::uint32_t>(fields + (long_headers_ ? 28 : 24))).Add(payload);
    return long_headers_ ? Add(std::uint64_t{0}) : Add(std::uint32_t{0});
  }

  OniWriter& AddNode(std::uint32_t node, std::uint32_t type, std::uint32_t name_bytes = 2) {
    AddHeader(long_headers_ ? 0x0D : 0x0C, node, 14, 0);
    Add(name_bytes);
    bytes_ += std::string("N\0", 2);
    return Add(type).Add(std::uint32_t{0});
  }

  OniWriter& AddProperty(const std::string& name, std::uint64_t value, std::uint32_t bytes = 8) {
    const auto name_bytes = static_cast<std::uint32_t>(name.size() + 1);
    AddHeader(0x03, 1, 4 + name_bytes + 4 + 8, 0);
    Add(name_bytes);
    bytes_ += name + '\0';
    return Add(bytes).Add(value);
  }

  OniWriter& AddFrame(std::uint32_t node, std::uint64_t time, std::uint32_t number) {
    AddHeader(0x0A, node, 12, 4);
    return Add(time).Add(number).Add(std::uint32_t{0xABABABAB});
  }

  OniWriter& AddEnd() { return AddHeader(0x0B, 0, 0, 0); }

  std::string& bytes() { return bytes_; }

 private:
  bool long_headers_;
  std::string bytes_;
};

class OniIndexTest : public ::testing::Test {
 protected:
  OniIndex Index(const std::string& bytes) const {
    std::ofstream(folder_ / "a.oni", std::ios::binary) << bytes;
    return IndexOniFile(folder_ / "a.oni");
  }
  std::string ErrorOf(const std::string& bytes) const {
    try {
      Index(bytes);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing thrown";
  }

  TemporaryFolder folder_;
};

TEST_F(OniIndexTest, ListsTheFramesOfTheFirstDepthStream) {
  for (const bool long_headers : {true, false}) {
    OniWriter file(long_headers);
    file.AddNode(0, 1).AddNode(1, 2).AddNode(2, 3);
    file.AddFrame(1, 0, 1).AddFrame(2, 5, 1).AddFrame(1, 33, 2).AddFrame(1, 66, 3).AddEnd();
    const std::size_t size = file.bytes().size();
    const OniIndex index = Index(file.bytes() + std::string(100, '\0'));
    EXPECT_THAT(index.frames,
                ElementsAre(OniIndexEntry{0, 1}, OniIndexEntry{33, 2}, OniIndexEntry{66, 3}));
    EXPECT_EQ(index.bytes, size);
  }
}

TEST_F(OniIndexTest, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(1, 2).AddFrame(1, 0, 1).bytes()), HasSubstr("cut off"));
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(1, 3).AddFrame(1, 0, 1).AddEnd().bytes()),
              HasSubstr("without depth"));
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(1, 2).AddEnd().bytes()), HasSubstr("without frames"));
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(7, 2).AddEnd().bytes()),
              HasSubstr("byte 24: got node 7, expected at most 2"));
  EXPECT_THAT(ErrorOf(OniWriter().AddHeader(0x55, 0, 0, 0).bytes()),
              HasSubstr("byte 24: got record type 85"));
  EXPECT_THAT(ErrorOf(OniWriter()
                          .Add(std::uint64_t{0})
                          .Add(std::uint64_t{0})
                          .Add(std::uint64_t{0})
                          .Add(std::uint64_t{0})
                          .bytes()),
              HasSubstr("byte 24: got no record"));
  OniWriter future;
  future.bytes()[4] = 2;
  EXPECT_THAT(ErrorOf(future.bytes()), HasSubstr("got version 2.0.1.0"));
}

TEST_F(OniIndexTest, RefusesSizesThatThePlayerWouldTrust) {
  EXPECT_THAT(ErrorOf(OniWriter().AddHeader(0x0A, 1, 12, 0xFFFFFFF0U).bytes()),
              HasSubstr("expected at most 5760000"));
  EXPECT_THAT(ErrorOf(OniWriter().AddHeader(0x0D, 1, 0x7FFFFFFFU, 0).bytes()),
              HasSubstr("expected at most 5760000"));
  EXPECT_THAT(ErrorOf(OniWriter().AddHeader(0x0A, 1, 0xFFFFFFF0U, 0).bytes()),  // wraps to 12
              HasSubstr("expected at most 5760000"));
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(1, 2, 0xFFFFFFFFU).AddEnd().bytes()),
              HasSubstr("a name of 4294967295 bytes"));
  EXPECT_THAT(ErrorOf(OniWriter().AddNode(1, 2).AddHeader(0x0A, 1, 4, 0).Add(7).AddEnd().bytes()),
              HasSubstr("got fields of 4 bytes, expected 12"));
}

TEST_F(OniIndexTest, RefusesPropertiesThatWouldCrashThePlayer) {
  const auto with = [](const std::string& name, std::uint64_t value, std::uint32_t bytes) {
    return OniWriter().AddNode(1, 2).AddProperty(name, value, bytes).AddFrame(1, 0, 1).AddEnd();
  };
  EXPECT_EQ(Index(with("oniRequiredFrameSize", 614400, 8).bytes()).frames.size(), 1U);
  EXPECT_THAT(ErrorOf(with("oniRequiredFrameSize", 0x80000000U, 8).bytes()),
              HasSubstr("oniRequiredFrameSize 2147483648, expected at most 5760000"));
  EXPECT_THAT(ErrorOf(with("xnMapOutputMode", 0xFFFFFFFFU, 8).bytes()),
              HasSubstr("xnMapOutputMode 4294967295, expected at most 8192"));
  EXPECT_THAT(ErrorOf(with("xnMir\xC0or", 1, 8).bytes()), HasSubstr("no plain word"));
  EXPECT_THAT(ErrorOf(with("xnMirror", 1, 9).bytes()), HasSubstr("got xnMirror of 9 bytes"));
}

TEST_F(OniIndexTest, SurvivesRandomDamage) {
  OniWriter file;
  file.AddNode(1, 2);
  for (std::uint32_t i = 0; i < 20; ++i) file.AddFrame(1, 33 * i, i + 1);
  file.AddEnd();
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = file.bytes();
    for (int i = 0; i < 4; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      EXPECT_LE(Index(damaged).frames.size(), 20U);
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.oni: byte "));
    }
  }
}

}  // namespace
}  // namespace fallen
