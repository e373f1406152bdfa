// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace fallen {
namespace {

/// `misses` of `count` sequences miss all of their ten frames, the others none.
std::vector<std::vector<FrameOutcome>> Sequences(int count, int misses) {
  std::vector<std::vector<FrameOutcome>> sequences;
  for (int i = 0; i < count; ++i) {
    FrameOutcome outcome;
    outcome.is_positive = true;
    if (i >= misses) outcome.hit_score = 0.9;
    sequences.emplace_back(10, outcome);
  }
  return sequences;
}

std::vector<double> MissRate(std::span<const FrameOutcome> frames) {
  double missed = 0;
  for (const FrameOutcome& frame : frames) missed += !frame.hit_score;
  return {missed / static_cast<double>(frames.size())};
}

TEST(Bootstrap, IntervalIsThatOfTheBinomialOverSequences) {
  // 30 of 100 sequences missed: standard error sqrt(0.3 * 0.7 / 100) = 0.0458, 1.96 of it 0.090;
  // over the 1000 frames, as if they were independent, it would be 0.028.
  const Interval interval = BootstrapIntervals(Sequences(100, 30), MissRate)[0];
  EXPECT_NEAR(interval.low, 0.30 - 0.090, 0.015);
  EXPECT_NEAR(interval.high, 0.30 + 0.090, 0.015);
}

TEST(Bootstrap, SequencesThatAreAllAlikeLeaveNoDoubt) {
  const Interval interval = BootstrapIntervals(Sequences(20, 0), MissRate)[0];
  EXPECT_EQ(interval.low, 0);
  EXPECT_EQ(interval.high, 0);
}

TEST(Bootstrap, SameSeedSameInterval) {
  BootstrapConfig config;
  config.seed = 7;
  const Interval first = BootstrapIntervals(Sequences(9, 4), MissRate, config)[0];
  const Interval again = BootstrapIntervals(Sequences(9, 4), MissRate, config)[0];
  EXPECT_EQ(first.low, again.low);
  EXPECT_EQ(first.high, again.high);
}

TEST(Bootstrap, FiguresThatAreNotDefinedGiveNaN) {
  const auto unknown = [](std::span<const FrameOutcome>) {
    return std::vector<double>{std::numeric_limits<double>::quiet_NaN()};
  };
  EXPECT_TRUE(std::isnan(BootstrapIntervals(Sequences(3, 1), unknown)[0].low));
}

TEST(Bootstrap, RefusesNoSequencesAndSettingsOutOfRange) {
  EXPECT_THROW(BootstrapIntervals({}, MissRate), std::invalid_argument);
  BootstrapConfig config;
  config.confidence = 1;
  EXPECT_THROW(BootstrapIntervals(Sequences(3, 1), MissRate, config), std::invalid_argument);
  config = {};
  config.resamples = 0;
  EXPECT_THROW(BootstrapIntervals(Sequences(3, 1), MissRate, config), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
