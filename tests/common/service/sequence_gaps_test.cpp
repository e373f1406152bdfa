// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/sequence_gaps.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace fallen {
namespace {

std::int64_t MissingAfter(std::initializer_list<std::int64_t> sequence) {
  SequenceGaps gaps;
  for (const std::int64_t seq : sequence) gaps.Add(seq);
  return gaps.missing();
}

TEST(SequenceGaps, CompleteSequenceMissesNothing) { EXPECT_EQ(MissingAfter({7, 8, 9, 10}), 0); }

TEST(SequenceGaps, GapsAddUp) { EXPECT_EQ(MissingAfter({0, 2, 3, 10}), 1 + 6); }

TEST(SequenceGaps, LateArrivalFillsItsGap) { EXPECT_EQ(MissingAfter({0, 2, 1, 3, 6, 4}), 1); }

TEST(SequenceGaps, SourceThatStartsAnewIsNoLoss) {
  EXPECT_EQ(MissingAfter({0, 1, 2, 0, 1, 2}), 0);
  EXPECT_EQ(MissingAfter({1000, 1001, 0, 1}), 0);
  EXPECT_EQ(MissingAfter({5, 5, 6}), 0);
}

TEST(SequenceGaps, GapWiderThanTheWindowIsCounted) { EXPECT_EQ(MissingAfter({0, 100, 101}), 99); }

TEST(SequenceGaps, ExtremeNumbersDoNotOverflow) {
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(MissingAfter({kMin, kMax, kMin, 0, kMax, kMax}), 0);
}

}  // namespace
}  // namespace fallen
