// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/logging.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

using std::chrono::seconds;

TEST(RepeatedWarnings, FirstIsSaidAtOnceThenOnceAnIntervalWithTheCount) {
  RepeatedWarnings warnings(seconds(10));
  const RepeatedWarnings::Clock::time_point start{seconds(100)};
  EXPECT_EQ(warnings.Note("late", "late frame", start), "late frame");
  EXPECT_EQ(warnings.Note("late", "late frame", start + seconds(1)), "");
  EXPECT_EQ(warnings.Note("late", "late frame", start + seconds(9)), "");
  EXPECT_EQ(warnings.Note("late", "late frame", start + seconds(10)),
            "late frame (and 2 like it before)");
  EXPECT_EQ(warnings.Note("late", "late frame", start + seconds(30)), "late frame");
}

TEST(RepeatedWarnings, KindsAreCountedApart) {
  RepeatedWarnings warnings(seconds(10));
  const RepeatedWarnings::Clock::time_point start{seconds(100)};
  EXPECT_EQ(warnings.Note("late", "late frame", start), "late frame");
  EXPECT_EQ(warnings.Note("damaged", "damaged frame", start), "damaged frame");
}

}  // namespace
}  // namespace fallen
