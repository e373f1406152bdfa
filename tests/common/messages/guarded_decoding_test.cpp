// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/guarded_decoding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "allocation_counter.hpp"
#include "fallen/messages/log_file.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::HasSubstr;

// What goes through the conversions once decoded; the others end at the decode.
template <class Message>
void Convert(const Message& message) {
  FromMessage(message);
}
void Convert(const ndt_map_t& message) {
  NdtMapFromMessage(message);
  ForegroundFromMessage(message);
}
void Convert(const service_status_t&) {}
void Convert(const model_t&) {}

template <class Message>
Message Sample();
template <>
pose_t Sample() {
  return samples::SamplePose();
}
template <>
depth_image_t Sample() {
  return ToMessage(samples::SampleDepthImage());
}
template <>
ndt_map_t Sample() {
  return ToMessage(samples::SampleHeader(), samples::SampleForeground());
}
template <>
clusters_t Sample() {
  return ToMessage(samples::SampleHeader(), samples::SampleSegmented());
}
template <>
fallen_persons_t Sample() {
  return ToMessage(samples::SampleHeader(), samples::SampleDecision());
}
template <>
ground_truth_t Sample() {
  return ToMessage(samples::SampleHeader(), samples::SampleTruth());
}
template <>
service_status_t Sample() {
  return samples::SampleStatus();
}
template <>
model_t Sample() {
  return samples::SampleModelMessage();
}
template <>
baseline_model_t Sample() {
  return ToMessage(samples::SampleBaselineModel());
}
template <>
environment_map_t Sample() {
  return ToMessage(EnvironmentMap{0.05, samples::SampleCells(5)}, "sample");
}

template <>
fall_alarm_t Sample() {
  return ToMessage(samples::SampleAlarm());
}
template <>
fall_alarm_ack_t Sample() {
  return ToMessage(samples::SampleAnswer());
}

template <class Message>
class GuardedDecoding : public testing::Test {
 protected:
  // Decodes, converts what can be decoded, and holds the decode to its promises.
  static bool Survives(const Bytes& bytes) {
    const std::size_t before = samples::AllocatedBytes();
    const Decoded<Message> decoded = DecodeMessage<Message>(bytes);
    // A row of one float takes 4 bytes on the wire and a vector of its own when decoded; then what
    // the message itself and an error text take.
    EXPECT_LE(samples::AllocatedBytes() - before, 16 * bytes.size() + 4096);
    EXPECT_EQ(decoded.error.empty(), static_cast<bool>(decoded));
    if (!decoded) return false;
    EXPECT_EQ(EncodeMessage(*decoded.message).size(), bytes.size());
    try {
      Convert(*decoded.message);
    } catch (const std::invalid_argument&) {
    }
    return true;
  }
};

using Types = testing::Types<pose_t, depth_image_t, ndt_map_t, clusters_t, fallen_persons_t,
                             ground_truth_t, service_status_t, model_t, baseline_model_t,
                             environment_map_t, fall_alarm_t, fall_alarm_ack_t>;
TYPED_TEST_SUITE(GuardedDecoding, Types);

TYPED_TEST(GuardedDecoding, GivesBackWhatWasEncoded) {
  const Bytes bytes = EncodeMessage(Sample<TypeParam>());
  const Decoded<TypeParam> decoded = DecodeMessage<TypeParam>(bytes);
  ASSERT_TRUE(decoded) << decoded.error;
  EXPECT_EQ(EncodeMessage(*decoded.message), bytes);
}

TYPED_TEST(GuardedDecoding, GivesBackAnEmptyMessage) {
  const Bytes bytes = EncodeMessage(TypeParam{});
  const Decoded<TypeParam> decoded = DecodeMessage<TypeParam>(bytes);
  ASSERT_TRUE(decoded) << decoded.error;
  EXPECT_EQ(EncodeMessage(*decoded.message), bytes);
}

TYPED_TEST(GuardedDecoding, RefusesTruncationAtEveryByte) {
  const Bytes bytes = EncodeMessage(Sample<TypeParam>());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Decoded<TypeParam> decoded = DecodeMessage<TypeParam>(std::span(bytes).first(size));
    EXPECT_FALSE(decoded) << size;
    EXPECT_THAT(decoded.error, testing::AllOf(HasSubstr("got "), HasSubstr("expected "))) << size;
  }
}

TYPED_TEST(GuardedDecoding, RefusesTrailingBytes) {
  Bytes bytes = EncodeMessage(Sample<TypeParam>());
  bytes.push_back(0);
  EXPECT_THAT(DecodeMessage<TypeParam>(bytes).error, HasSubstr("1 more bytes"));
}

TYPED_TEST(GuardedDecoding, RefusesAnotherHash) {
  Bytes bytes = EncodeMessage(Sample<TypeParam>());
  for (int byte = 0; byte < 8; ++byte) {
    Bytes other = bytes;
    other[byte] ^= 1;
    EXPECT_THAT(DecodeMessage<TypeParam>(other).error, HasSubstr("another type"));
  }
}

TYPED_TEST(GuardedDecoding, SurvivesHostileNumbersAtEveryByte) {
  const Bytes bytes = EncodeMessage(Sample<TypeParam>());
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
  for (const std::int32_t hostile :
       {-1, 0, 1, 2, 255, 65536, 1 << 24, 1 << 30, kMax, kMax - 1, kMin, kMin + 1})
    for (std::size_t offset = 8; offset + 4 <= bytes.size(); ++offset) {
      Bytes other = bytes;
      for (int byte = 0; byte < 4; ++byte)
        other[offset + byte] =
            static_cast<std::uint8_t>(static_cast<std::uint32_t>(hostile) >> (24 - 8 * byte));
      this->Survives(other);
    }
}

TYPED_TEST(GuardedDecoding, SurvivesRandomDamage) {
  const Bytes bytes = EncodeMessage(Sample<TypeParam>());
  // Other damage: --gtest_shuffle --gtest_random_seed=N.
  std::mt19937 random(1 + static_cast<unsigned>(testing::UnitTest::GetInstance()->random_seed()));
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes other = bytes;
    for (auto flips = 1 + random() % 3; flips > 0; --flips)
      other[8 + random() % (other.size() - 8)] = static_cast<std::uint8_t>(random());
    if (random() % 8 == 0) other.resize(8 + random() % (other.size() - 8));
    if (random() % 8 == 0)
      other.insert(other.begin() + 8 + random() % (other.size() - 7), random() % 16, 0);
    accepted += this->Survives(other) ? 1 : 0;
  }
  EXPECT_GT(accepted, 0) << "damage to a value is no damage to the wire";
}

TEST(DecodeHeader, ReadsTheHeaderOfAWholeOrABrokenMessage) {
  const ndt_map_t map = Sample<ndt_map_t>();
  const Bytes bytes = EncodeMessage(map);
  const std::size_t header_end = 8 + map.header._getEncodedSizeNoHash();
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    const auto header = DecodeHeader(std::span(bytes).first(size), ndt_map_t::getHash());
    ASSERT_EQ(header.has_value(), size >= header_end) << size;
    if (!header) continue;
    EXPECT_EQ(header->utime, map.header.utime);
    EXPECT_EQ(header->seq, map.header.seq);
    EXPECT_EQ(header->sensor_name, map.header.sensor_name);
  }
}

TEST(DecodeHeader, RefusesAnotherTypeAndHostileNames) {
  Bytes bytes = EncodeMessage(Sample<ndt_map_t>());
  EXPECT_FALSE(DecodeHeader(bytes, clusters_t::getHash()));
  for (const int length : {0x00, 0x7F, 0xFF}) {
    std::fill_n(bytes.begin() + 8 + 16, 4, static_cast<std::uint8_t>(length));  // of sensor_name
    EXPECT_FALSE(DecodeHeader(bytes, ndt_map_t::getHash())) << length;
  }
}

TEST(GuardedDecodingErrors, SayWhereAndWhat) {
  EXPECT_EQ(DecodeMessage<pose_t>(Bytes{1, 2}).error, "pose_t: got 2 bytes, expected 8 or more");

  Bytes map = EncodeMessage(Sample<ndt_map_t>());
  map[map.size() - 7 - 4] = 0xFF;  // flag_count, before 7 flags
  EXPECT_EQ(DecodeMessage<ndt_map_t>(map).error,
            "ndt_map_t.flag_count: got -16777209, expected >= 0");

  Bytes bytes = EncodeMessage(Sample<fallen_persons_t>());
  bytes[8 + 16] = 0x7F;  // the length of header.sensor_name
  EXPECT_THAT(
      DecodeMessage<fallen_persons_t>(bytes).error,
      testing::StartsWith("header_t.sensor_name: got string length 2130706438, expected 1 to "));
}

TEST(GuardedDecodingErrors, RowsWithoutColumnsAreRefused) {
  clusters_t clusters = Sample<clusters_t>();
  clusters.dimension = 0;
  clusters.descriptor_count = 1 << 30;
  clusters.descriptor.clear();
  Bytes bytes(clusters.getEncodedSize());
  ASSERT_GT(clusters.encode(bytes.data(), 0, static_cast<int>(bytes.size())), 0);
  EXPECT_EQ(DecodeMessage<clusters_t>(bytes).error,
            "clusters_t.descriptor: got 1073741824 empty rows, expected none");
}

}  // namespace
}  // namespace fallen
