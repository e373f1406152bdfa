// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/random.hpp"

#include <gtest/gtest.h>

namespace fallen::sim {
namespace {

TEST(StableHash, IsFnv1a) {
  // Published test vectors of 64-bit FNV-1a.
  EXPECT_EQ(StableHash(""), 0xcbf29ce484222325ull);
  EXPECT_EQ(StableHash("a"), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(StableHash("foobar"), 0x85944171f73967e8ull);
}

TEST(MixBits, IsSplitMix64) {
  // First output of the reference SplitMix64 for the state 1234567.
  EXPECT_EQ(MixBits(1234567), 6457827717110365317ull);
}

TEST(Random, HasTheMomentsItPromises) {
  constexpr int kDraws = 200000;
  Random random(3);
  double uniform = 0, normal = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    uniform += random.Uniform();
    const double value = random.Normal(2, 3);
    normal += value;
    squares += (value - 2) * (value - 2);
  }
  EXPECT_NEAR(uniform / kDraws, 0.5, 4 * 0.2887 / std::sqrt(kDraws));
  EXPECT_NEAR(normal / kDraws, 2, 4 * 3 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 9, 4 * 9 * std::sqrt(2.0 / kDraws));
}

TEST(Random, StreamsAreReproducibleAndDifferByName) {
  Random a = Random::Stream(5, "room"), b = Random::Stream(5, "room"),
         c = Random::Stream(5, "body");
  const auto first = a.Bits();
  EXPECT_EQ(first, b.Bits());
  EXPECT_NE(first, c.Bits());
}

TEST(Random, IntegersReachBothEndsAndNoFarther) {
  Random random(1);
  int low = 100, high = -100;
  for (int i = 0; i < 1000; ++i) {
    const int value = random.Integer(-2, 3);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_EQ(low, -2);
  EXPECT_EQ(high, 3);
}

}  // namespace
}  // namespace fallen::sim
