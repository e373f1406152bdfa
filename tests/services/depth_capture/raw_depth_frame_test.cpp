// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/raw_depth_frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <vector>

namespace fallen {
namespace {

using ::testing::ElementsAre;

constexpr FieldOfView kRightAngles{std::numbers::pi / 2, std::numbers::pi / 2};

/// Memory of a driver that pads its rows of three by one.
class PaddedFrame {
 public:
  PaddedFrame() {
    bytes_.resize(values_.size() * sizeof(values_[0]));
    std::memcpy(bytes_.data(), values_.data(), bytes_.size());
    frame.bytes = bytes_;
    frame.width = frame.full_width = 3;
    frame.height = frame.full_height = 2;
    frame.stride_bytes = 8;
  }
  RawDepthFrame frame;

 private:
  std::vector<std::uint16_t> values_{1, 2, 3, 9, 4, 5, 60000};
  std::vector<std::uint8_t> bytes_;
};

TEST(ToDepthImageTest, CopiesRowsWithoutTheirPadding) {
  const PaddedFrame padded;
  const DepthImage image = ToDepthImage(padded.frame, kRightAngles, false);
  EXPECT_THAT(image.depth, ElementsAre(1, 2, 3, 4, 5, 60000));
  EXPECT_EQ(image.depth_unit_m, 0.001);
  image.Validate();
}

TEST(ToDepthImageTest, StatesTheCamera) {
  PaddedFrame padded;
  padded.frame.unit = DepthUnit::k100Um;
  const DepthImage image = ToDepthImage(padded.frame, kRightAngles, false);
  // tan 45 degrees is 1: f is half the side.
  EXPECT_NEAR(image.intrinsics.fx, 1.5, 1e-12);
  EXPECT_NEAR(image.intrinsics.fy, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(image.intrinsics.cx, 1.0);
  EXPECT_DOUBLE_EQ(image.intrinsics.cy, 0.5);
  EXPECT_EQ(image.depth_unit_m, 0.0001);
}

TEST(ToDepthImageTest, SwapsAMirroredPictureBack) {
  const PaddedFrame padded;
  const DepthImage image = ToDepthImage(padded.frame, kRightAngles, true);
  EXPECT_THAT(image.depth, ElementsAre(3, 2, 1, 60000, 5, 4));
  EXPECT_DOUBLE_EQ(image.intrinsics.cx, 1.0);
}

TEST(ToDepthImageTest, KeepsTheCameraOfACroppedPicture) {
  PaddedFrame padded;
  padded.frame.full_width = 10;
  padded.frame.full_height = 8;
  padded.frame.crop_x = 6;
  padded.frame.crop_y = 1;
  const DepthImage image = ToDepthImage(padded.frame, kRightAngles, false);
  // The whole picture's middle (4.5, 3.5) and focal lengths, seen from (6, 1).
  EXPECT_NEAR(image.intrinsics.fx, 5, 1e-12);
  EXPECT_NEAR(image.intrinsics.fy, 4, 1e-12);
  EXPECT_DOUBLE_EQ(image.intrinsics.cx, -1.5);
  EXPECT_DOUBLE_EQ(image.intrinsics.cy, 2.5);
  // Mirrored, what was 1.5 left of the part is as far to its right.
  EXPECT_DOUBLE_EQ(ToDepthImage(padded.frame, kRightAngles, true).intrinsics.cx, 3.5);
}

TEST(ToDepthImageTest, RefusesWhatDoesNotFitTogether) {
  const auto refuses = [](auto spoil) {
    PaddedFrame padded;
    spoil(padded.frame);
    EXPECT_THROW(ToDepthImage(padded.frame, kRightAngles, false), BadFrame);
  };
  refuses([](RawDepthFrame& frame) { frame.bytes = frame.bytes.first(13); });
  refuses([](RawDepthFrame& frame) { frame.bytes = {}; });
  refuses([](RawDepthFrame& frame) { frame.stride_bytes = 5; });
  refuses([](RawDepthFrame& frame) { frame.stride_bytes = -8; });
  refuses([](RawDepthFrame& frame) { frame.width = 0; });
  refuses([](RawDepthFrame& frame) { frame.height = 9000; });
  refuses([](RawDepthFrame& frame) { frame.crop_x = 1; });
  refuses([](RawDepthFrame& frame) { frame.crop_y = -1; });
  const PaddedFrame good;
  EXPECT_THROW(ToDepthImage(good.frame, {0, 1}, false), BadFrame);
  EXPECT_THROW(ToDepthImage(good.frame, {1, 4}, false), BadFrame);
  EXPECT_THROW(ToDepthImage(good.frame, {std::nan(""), 1}, false), BadFrame);
}

}  // namespace
}  // namespace fallen
