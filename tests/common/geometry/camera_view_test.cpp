// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/camera_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace fallen {
namespace {

DepthImage WallImage(int width, int height, std::uint16_t depth) {
  DepthImage image;
  image.intrinsics = {
      width, height, 0.8 * width, 0.8 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
  image.depth.assign(static_cast<std::size_t>(width) * height, depth);
  return image;
}

TEST(CameraView, KeepsTheFieldOfViewAndTheDepthAtAnySize) {
  for (const auto& [width, height] : {std::pair{320, 240}, {640, 480}, {321, 241}, {8, 6}}) {
    const DepthImage image = WallImage(width, height, 2500);
    const CameraView view = MakeCameraView(image);
    EXPECT_LE(view.intrinsics.width, 32);
    EXPECT_EQ(view.depth_mm.size(),
              static_cast<std::size_t>(view.intrinsics.width) * view.intrinsics.height);
    for (const double u : {0.0, 0.3 * width, width - 1.0})
      for (const double v : {0.0, 0.6 * height, height - 1.0})
        EXPECT_EQ(view.DepthTowards(image.intrinsics.Deproject(u, v, 7)), 2.5) << u << " " << v;
    EXPECT_FALSE(view.DepthTowards(image.intrinsics.Deproject(-0.1 * width, 1, 2)));
    EXPECT_FALSE(view.DepthTowards(image.intrinsics.Deproject(1, 1.1 * height, 2)));
    EXPECT_FALSE(view.DepthTowards({0, 0, -1}));
    EXPECT_FALSE(view.DepthTowards({0, 0, 0}));
  }
}

TEST(CameraView, TellsTheNearFromTheFarSide) {
  DepthImage image = WallImage(320, 240, 4000);
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 160; ++u) image.depth[v * 320 + u] = 1000;
  const CameraView view = MakeCameraView(image);
  EXPECT_EQ(view.DepthTowards({-0.1, 0, 1}), 1.0);
  EXPECT_EQ(view.DepthTowards({0.1, 0, 1}), 4.0);
}

TEST(CameraView, BlocksThatAreMostlyNotMeasuredSayNothing) {
  DepthImage image = WallImage(320, 240, 3000);
  for (std::size_t i = 0; i < image.depth.size(); ++i)
    if (i % 7 != 0) image.depth[i] = 0;
  EXPECT_FALSE(MakeCameraView(image).DepthTowards({0, 0, 1}));
  for (std::size_t i = 0; i < image.depth.size(); ++i) image.depth[i] = i % 7 == 0 ? 0 : 3000;
  EXPECT_EQ(MakeCameraView(image).DepthTowards({0, 0, 1}), 3.0);
}

TEST(CameraView, KeepsTheMedianOfWhatIsMeasured) {
  std::mt19937 random(1);
  for (const auto& [width, height] :
       {std::pair{160, 120}, {157, 118}, {90, 7}, {321, 241}, {640, 480}}) {
    DepthImage image = WallImage(width, height, 0);
    for (std::uint16_t& depth : image.depth)
      depth = random() % 5 < 2 ? 0 : static_cast<std::uint16_t>(1 + random() % 32767);
    const CameraView view = MakeCameraView(image);
    const int block = (width + 31) / 32;
    const int step = (block + 4) / 5;  // up to five samples a side, evenly spread
    const int first = (step - 1) / 2;
    for (int row = 0; row < view.intrinsics.height; ++row)
      for (int column = 0; column < view.intrinsics.width; ++column) {
        std::vector<std::uint16_t> measured;
        int looked_at = 0;
        for (int v = row * block + first; v < std::min((row + 1) * block, height); v += step)
          for (int u = column * block + first; u < std::min((column + 1) * block, width);
               u += step, ++looked_at)
            if (const auto depth = image.depth[v * width + u]; depth != 0)
              measured.push_back(depth);
        std::sort(measured.begin(), measured.end());
        const bool is_known =
            !measured.empty() && 2 * static_cast<int>(measured.size()) >= looked_at;
        EXPECT_EQ(view.depth_mm[row * view.intrinsics.width + column],
                  is_known ? measured[measured.size() / 2] : 0)
            << width << " pixels, " << row << " " << column;
      }
  }
}

TEST(CameraView, KnowsTheUnitAndHowFarItCanTell) {
  DepthImage image = WallImage(32, 24, 12345);
  image.depth_unit_m = 1e-4;
  EXPECT_EQ(MakeCameraView(image).DepthTowards({0, 0, 1}), 1.235);
  image.depth_unit_m = 1e-2;
  EXPECT_EQ(MakeCameraView(image).DepthTowards({0, 0, 1}), 32.767);
}

TEST(CameraView, WithoutAnImageNothingIsSeen) {
  EXPECT_FALSE(CameraView{}.is_known());
  EXPECT_FALSE(CameraView{}.DepthTowards({0, 0, 1}));
  EXPECT_THROW(MakeCameraView(DepthImage{}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
