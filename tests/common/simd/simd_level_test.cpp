// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/simd/simd_level.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

int Portable() { return 0; }
int Avx2() { return 1; }
int Avx512() { return 2; }

TEST(SimdLevel, IsTheMachinesUnlessLimited) {
  EXPECT_EQ(ActiveSimdLevel(), MachineSimdLevel());
  LimitSimdLevel(SimdLevel::kPortable);
  EXPECT_EQ(ActiveSimdLevel(), SimdLevel::kPortable);
  LimitSimdLevel(SimdLevel::kAvx512);
  EXPECT_EQ(ActiveSimdLevel(), MachineSimdLevel());
}

TEST(SimdLevel, ChoosesTheVariantOfTheActiveLevel) {
  std::vector<SimdLevel> seen;
  test::AtEverySimdLevel([&](SimdLevel level) {
    seen.push_back(level);
    EXPECT_EQ(ChooseSimd(Portable, Avx2, Avx512)(), static_cast<int>(level));
  });
  EXPECT_EQ(seen.back(), MachineSimdLevel());
}

}  // namespace
}  // namespace fallen
