// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/feature_binning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace fallen {
namespace {

std::vector<int> BinSizes(const std::vector<float>& values, const std::vector<float>& cuts) {
  std::vector<int> sizes(cuts.size() + 1);
  for (const float value : values)
    ++sizes[std::lower_bound(cuts.begin(), cuts.end(), value) - cuts.begin()];
  return sizes;
}

TEST(QuantileCuts, PartsAllValuesThatAreFewEnough) {
  const std::vector<float> values{0, 0, 0, 0, 0, 0, 1, 2, 2, 4};
  EXPECT_EQ(QuantileCuts(values, 4), (std::vector<float>{0.5F, 1.5F, 3.0F}));
  EXPECT_TRUE(QuantileCuts(std::vector<float>{3, 3, 3}, 4).empty());
  EXPECT_TRUE(QuantileCuts(std::vector<float>{}, 4).empty());
}

TEST(QuantileCuts, MakesBinsOfAboutEqualSize) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal(5, 2);
  std::vector<float> values(10000);
  for (float& value : values) value = normal(random);
  std::sort(values.begin(), values.end());
  const std::vector<float> cuts = QuantileCuts(values, 256);
  ASSERT_EQ(cuts.size(), 255U);
  for (const int size : BinSizes(values, cuts)) EXPECT_NEAR(size, 10000 / 256.0, 2);
}

TEST(QuantileCuts, GivesAFrequentValueABinOfItsOwn) {
  // As in a histogram feature: mostly zero, the rest spread.
  std::vector<float> values(9000, 0.0F);
  for (int i = 1; i <= 1000; ++i) values.push_back(static_cast<float>(i) / 1000);
  const std::vector<float> cuts = QuantileCuts(values, 16);
  ASSERT_EQ(cuts.size(), 15U);
  EXPECT_GT(cuts[0], 0.0F);
  EXPECT_LT(cuts[0], 0.001F);
  const std::vector<int> sizes = BinSizes(values, cuts);
  for (std::size_t b = 1; b < sizes.size(); ++b) EXPECT_NEAR(sizes[b], 1000 / 15.0, 1);

  std::vector<float> last(1000);
  for (int i = 0; i < 1000; ++i) last[i] = static_cast<float>(i) / 1000;
  last.insert(last.end(), 9000, 7.0F);
  EXPECT_GT(QuantileCuts(last, 16).back(), 0.999F);
}

TEST(QuantileCuts, PartsNeighbouringFloatsAndExtremes) {
  const float one_up = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(QuantileCuts(std::vector<float>{1.0F, one_up}, 2), (std::vector<float>{1.0F}));
  const float largest = std::numeric_limits<float>::max();
  const float tiny = std::numeric_limits<float>::denorm_min();
  const std::vector<float> cuts = QuantileCuts(std::vector<float>{-largest, 0, tiny, largest}, 4);
  ASSERT_EQ(cuts.size(), 3U);
  EXPECT_LT(cuts[0], 0.0F);
  EXPECT_EQ(cuts[1], 0.0F);
  EXPECT_TRUE(std::isfinite(cuts[2]));
}

TEST(BinFeatures, AgreesWithComparingValuesToCuts) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> pick(0, 5000);
  FeatureMatrix features(3000, 3);
  for (Eigen::Index i = 0; i < features.size(); ++i)
    features.data()[i] = static_cast<float>(pick(random)) / 7;
  const BinnedFeatures binned = BinFeatures(features, 64, 2);
  ASSERT_EQ(binned.feature_count(), 3);
  for (int f = 0; f < 3; ++f) {
    ASSERT_EQ(binned.cuts[f].size(), 63U);
    for (int i = 0; i < 3000; ++i)
      for (int k = 0; k < 63; ++k)
        ASSERT_EQ(binned.column(f)[i] <= k, features(i, f) <= binned.cuts[f][k]);
  }
}

}  // namespace
}  // namespace fallen
