// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sizes and times of the depth codecs on real recordings: the table in lcmtypes/README.md.
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "fallen/messages/depth_codec.hpp"

namespace fallen {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

std::vector<std::uint16_t> ReadPng(const std::filesystem::path& path) {
  std::vector<std::uint16_t> image(kWidth * kHeight);
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(reader);
  png_init_io(reader, file);
  png_read_png(reader, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
  for (int v = 0; v < kHeight; ++v)
    std::memcpy(&image[v * kWidth], png_get_rows(reader, info)[v], 2 * kWidth);
  png_destroy_read_struct(&reader, &info, nullptr);
  std::fclose(file);
  return image;
}

// Every fourth image of long recordings.
std::vector<std::vector<std::uint16_t>> Images(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::vector<std::uint16_t>> images;
  for (std::size_t i = 0; i<paths.size(); i += paths.size()> 20 ? 4 : 1)
    images.push_back(ReadPng(paths[i]));
  return images;
}

struct Figures {
  double mean_bytes = 0;
  double max_bytes = 0;
  double encode_ms = 0;  // medians
  double decode_ms = 0;
};

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

Figures Measure(const std::vector<std::vector<std::uint16_t>>& images,
                DepthCompression compression) {
  using Clock = std::chrono::steady_clock;
  const auto ms = [](auto span) { return std::chrono::duration<double, std::milli>(span).count(); };
  Figures figures;
  std::vector<double> encode, decode;
  for (const auto& image : images) {
    const auto start = Clock::now();
    const EncodedDepth encoded = EncodeDepth(image, kWidth, compression);
    const auto middle = Clock::now();
    const auto decoded = DecodeDepth(encoded.bytes, encoded.compression, kWidth, kHeight);
    const auto end = Clock::now();
    EXPECT_EQ(decoded, image);
    EXPECT_EQ(encoded.compression, compression);
    encode.push_back(ms(middle - start));
    decode.push_back(ms(end - middle));
    figures.mean_bytes +=
        static_cast<double>(encoded.bytes.size()) / static_cast<double>(images.size());
    figures.max_bytes = std::max(figures.max_bytes, static_cast<double>(encoded.bytes.size()));
  }
  figures.encode_ms = Median(encode);
  figures.decode_ms = Median(decode);
  return figures;
}

TEST(DepthCodecFigures, TheDefaultIsTheSmallestOnEveryRealRecording) {
  const std::filesystem::path root = FALLEN_SOURCE_DIR "/../shared/real";
  if (!std::filesystem::exists(root)) GTEST_SKIP() << root << " is not there";
  for (const char* name : {"7-scenes-kitchen", "urfd-fall-01", "pcl-office"}) {
    const auto images = Images(root / name / "depth");
    double smallest = 1e9, ours = 0;
    for (const auto& [compression, label] : EnumNames(DepthCompression{})) {
      const Figures f = Measure(images, compression);
      std::printf(
          "%-18s %-12s mean %6.1f KB  max %6.1f KB  ratio %5.2f  encode %5.2f ms  decode %5.2f "
          "ms\n",
          name, std::string(label).c_str(), f.mean_bytes / 1e3, f.max_bytes / 1e3,
          2.0 * kWidth * kHeight / f.mean_bytes, f.encode_ms, f.decode_ms);
      smallest = std::min(smallest, f.mean_bytes);
      if (compression != kDefaultDepthCompression) continue;
      ours = f.mean_bytes;
      // Up to about 200 KB travel on untuned buffers.
      EXPECT_LT(f.max_bytes, 210e3) << name;
    }
    EXPECT_EQ(ours, smallest) << name;
  }
}

}  // namespace
}  // namespace fallen
