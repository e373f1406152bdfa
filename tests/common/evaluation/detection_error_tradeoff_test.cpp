// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/detection_error_tradeoff.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fallen {
namespace {

FrameOutcome Positive(std::optional<double> hit, std::vector<double> false_scores = {}) {
  return {true, hit, std::move(false_scores)};
}
FrameOutcome Negative(std::vector<double> false_scores = {}) {
  return {false, std::nullopt, std::move(false_scores)};
}

TEST(DetectionErrorTradeoff, AgreesWithACurveWorkedByHand) {
  // Four frames, two persons. Accepting from 0.9: one hit. From 0.8: a false one. From 0.4: both
  // hit.
  const std::vector<FrameOutcome> outcomes{Positive(0.9), Positive(0.4, {0.2}), Negative({0.8}),
                                           Negative()};
  const DetectionErrorTradeoff curve = ComputeTradeoff(outcomes);
  EXPECT_EQ(curve.frames, 4);
  EXPECT_EQ(curve.positives, 2);
  ASSERT_EQ(curve.points.size(), 5u);
  EXPECT_EQ(curve.points[0].miss_rate, 1);
  EXPECT_EQ(curve.points[1].miss_rate, 0.5);
  EXPECT_EQ(curve.points[1].false_positives, 0);
  EXPECT_EQ(curve.points[2].false_positives_per_frame, 0.25);
  EXPECT_EQ(curve.points[3].miss_rate, 0);
  EXPECT_EQ(curve.points[4].false_positives_per_frame, 0.5);
  EXPECT_EQ(curve.MissRateAt(0.01), 0.5);
  EXPECT_EQ(curve.MissRateAt(0.25), 0);
  EXPECT_EQ(curve.AtThreshold(0.8).false_positives, 1);
  EXPECT_EQ(curve.AtThreshold(0.81).false_positives, 0);
  EXPECT_EQ(curve.AtThreshold(2).true_positives, 0);
}

TEST(DetectionErrorTradeoff, EqualScoresAreAcceptedTogether) {
  const std::vector<FrameOutcome> outcomes{Positive(0.5), Negative({0.5})};
  const DetectionErrorTradeoff curve = ComputeTradeoff(outcomes);
  ASSERT_EQ(curve.points.size(), 2u);
  EXPECT_EQ(curve.points[1].true_positives, 1);
  EXPECT_EQ(curve.points[1].false_positives, 1);
}

TEST(DetectionErrorTradeoff, LogAverageIsTheConstantOfAConstantCurve) {
  std::vector<FrameOutcome> outcomes(40, Positive(0.9));
  for (int i = 0; i < 10; ++i) outcomes[i] = Positive(std::nullopt);
  EXPECT_NEAR(ComputeTradeoff(outcomes).LogAverageMissRate(), 0.25, 1e-12);
}

TEST(DetectionErrorTradeoff, APerfectCurveCountsHalfAMiss) {
  const std::vector<FrameOutcome> outcomes(50, Positive(0.9));
  EXPECT_NEAR(ComputeTradeoff(outcomes).LogAverageMissRate(), 0.01, 1e-12);
}

TEST(DetectionErrorTradeoff, WithoutPositivesThereIsNoMissRate) {
  const DetectionErrorTradeoff curve = ComputeTradeoff(std::vector<FrameOutcome>{Negative({0.3})});
  EXPECT_TRUE(std::isnan(curve.MissRateAt(1)));
  EXPECT_TRUE(std::isnan(curve.LogAverageMissRate()));
  EXPECT_EQ(curve.AtThreshold(0).false_positives, 1);
  EXPECT_TRUE(std::isnan(ComputeTradeoff({}).MissRateAt(1)));
}

}  // namespace
}  // namespace fallen
