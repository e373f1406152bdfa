// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/depth_codec.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace fallen {
namespace {

using Image = std::vector<std::uint16_t>;

constexpr DepthCompression kAll[] = {DepthCompression::kNone, DepthCompression::kZlib,
                                     DepthCompression::kLz4, DepthCompression::kDifferences,
                                     DepthCompression::kRanks};

// A slanted wall with holes and noise.
Image Wall(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      image.push_back(
          random() % 10 == 0 ? 0 : static_cast<std::uint16_t>(800 + 3 * u + v + random() % 4));
  return image;
}

Image Noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Image image(size);
  for (auto& value : image) value = static_cast<std::uint16_t>(random());
  return image;
}

class DepthCodec : public testing::TestWithParam<DepthCompression> {
 protected:
  void ExpectRoundTrip(const Image& image, int width) {
    const EncodedDepth encoded = EncodeDepth(image, width, GetParam());
    const int height = static_cast<int>(image.size()) / width;
    EXPECT_EQ(DecodeDepth(encoded.bytes, encoded.compression, width, height), image);
  }
};

std::string CodecName(const testing::TestParamInfo<DepthCompression>& tested) {
  return std::string(EnumName(tested.param));
}
INSTANTIATE_TEST_SUITE_P(All, DepthCodec, testing::ValuesIn(kAll), CodecName);

TEST_P(DepthCodec, GivesBackWhatWasPutIn) { ExpectRoundTrip(Wall(64, 48, 1), 64); }
TEST_P(DepthCodec, GivesBackAnEmptyImage) { ExpectRoundTrip(Image(64 * 48, 0), 64); }
TEST_P(DepthCodec, GivesBackOnePixel) { ExpectRoundTrip({65535}, 1); }
TEST_P(DepthCodec, GivesBackOneColumnAndOneRow) {
  ExpectRoundTrip({0, 1, 65535, 0, 32768, 1}, 1);
  ExpectRoundTrip({0, 1, 65535, 0, 32768, 1}, 6);
}
TEST_P(DepthCodec, GivesBackExtremeSteps) {
  Image image;
  for (int i = 0; i < 4096; ++i)
    image.push_back(i % 2 == 0 ? 65535 : static_cast<std::uint16_t>(i % 5));
  ExpectRoundTrip(image, 64);
}
TEST_P(DepthCodec, GivesBackEveryValueThereIs) {
  Image image(65536);
  for (int i = 0; i < 65536; ++i) image[i] = static_cast<std::uint16_t>(i);
  ExpectRoundTrip(image, 256);
}
TEST_P(DepthCodec, GivesBackRandomBits) {
  for (unsigned seed = 0; seed < 20; ++seed) ExpectRoundTrip(Noise(160 * 120, seed), 160);
}
TEST_P(DepthCodec, IsDeterministic) {
  const Image image = Wall(160, 120, 3);
  const EncodedDepth first = EncodeDepth(image, 160, GetParam());
  EncodeDepth(Noise(640, 4), 64, GetParam());  // leaves the kept contexts in another state
  EXPECT_EQ(EncodeDepth(image, 160, GetParam()).bytes, first.bytes);
}
TEST_P(DepthCodec, RefusesEveryTruncationAndExcess) {
  const Image image = Wall(20, 10, 5);
  const EncodedDepth encoded = EncodeDepth(image, 20, GetParam());
  for (std::size_t size = 0; size < encoded.bytes.size(); ++size) {
    const std::span<const std::uint8_t> part(encoded.bytes.data(), size);
    EXPECT_THROW(DecodeDepth(part, encoded.compression, 20, 10), std::invalid_argument) << size;
  }
  std::vector<std::uint8_t> longer = encoded.bytes;
  longer.push_back(0);
  EXPECT_THROW(DecodeDepth(longer, encoded.compression, 20, 10), std::invalid_argument);
}
TEST_P(DepthCodec, RefusesAnotherImageSize) {
  const EncodedDepth encoded = EncodeDepth(Wall(20, 10, 5), 20, GetParam());
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, 20, 11), std::invalid_argument);
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, 19, 10), std::invalid_argument);
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, 4096, 4096), std::invalid_argument);
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, 0, 10), std::invalid_argument);
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, -20, -10), std::invalid_argument);
  EXPECT_THROW(DecodeDepth(encoded.bytes, encoded.compression, 2147483647, 2147483647),
               std::invalid_argument);
}
TEST_P(DepthCodec, SurvivesRandomDamage) {
  const Image image = Wall(64, 48, 6);
  const EncodedDepth encoded = EncodeDepth(image, 64, GetParam());
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::uint8_t> damaged = encoded.bytes;
    for (auto flips = 1 + random() % 4; flips > 0; --flips)
      damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    try {
      EXPECT_EQ(DecodeDepth(damaged, encoded.compression, 64, 48).size(), image.size());
    } catch (const std::invalid_argument&) {
    }
  }
}

TEST(EncodeDepth, FallsBackFromRanksWhenThereAreTooManyValues) {
  Image image(32768);
  for (int i = 0; i < 32768; ++i) image[i] = static_cast<std::uint16_t>(i + 1);
  EXPECT_EQ(EncodeDepth(image, 256, DepthCompression::kRanks).compression,
            DepthCompression::kDifferences);
  image[5] = 0;
  EXPECT_EQ(EncodeDepth(image, 256, DepthCompression::kRanks).compression,
            DepthCompression::kRanks);
}

TEST(EncodeDepth, RefusesWhatIsNoImage) {
  EXPECT_THROW(EncodeDepth(Image{}, 1), std::invalid_argument);
  EXPECT_THROW(EncodeDepth(Image(10), 0), std::invalid_argument);
  EXPECT_THROW(EncodeDepth(Image(10), 3), std::invalid_argument);
}

TEST(DecodeDepth, NamesWhatItGotAndExpected) {
  try {
    DecodeDepth(std::vector<std::uint8_t>(5), DepthCompression::kNone, 2, 2);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "depth_image_t.data: got 5 bytes, expected 8");
  }
}

TEST(DecodeDepth, RefusesAnUnknownCompression) {
  EXPECT_THROW(DecodeDepth(std::vector<std::uint8_t>(8), DepthCompression{9}, 2, 2),
               std::invalid_argument);
}

}  // namespace
}  // namespace fallen
