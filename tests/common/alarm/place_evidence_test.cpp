// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/place_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fallen {
namespace {

const AlarmConfig kConfig;

/// Camera 2 m from the place, so many degrees round it.
Eigen::Vector3d Around(double degrees, double distance_m = 2) {
  const double angle = degrees * std::numbers::pi / 180;
  return {distance_m * std::cos(angle), distance_m * std::sin(angle), 0};
}

void Look(PlaceEvidence& evidence, double log_odds, const Eigen::Vector3d& from, double seconds) {
  for (double t = 0; t < seconds - 1e-9; t += 0.1) evidence.Add(log_odds, from, 0.1, kConfig);
}

TEST(PlaceEvidence, OneViewpointSaysNoMoreThanOneFrameHoweverLong) {
  PlaceEvidence evidence;
  EXPECT_EQ(evidence.log_odds(), 0);
  Look(evidence, 2, Around(0), kConfig.settle_s);
  EXPECT_NEAR(evidence.log_odds(), 2 * (1 - std::exp(-1)), 1e-9);
  Look(evidence, 2, Around(0), 100);
  EXPECT_NEAR(evidence.log_odds(), 2, 1e-6);
  EXPECT_EQ(evidence.supporting_views(), 1);
}

TEST(PlaceEvidence, DependsOnTimeNotOnTheRateOfFrames) {
  PlaceEvidence slow, fast;
  for (int i = 0; i < 3; ++i) slow.Add(2, Around(0), 0.3, kConfig);
  for (int i = 0; i < 90; ++i) fast.Add(2, Around(0), 0.01, kConfig);
  EXPECT_NEAR(slow.log_odds(), fast.log_odds(), 1e-9);
}

TEST(PlaceEvidence, ViewpointsAddUp) {
  PlaceEvidence evidence;
  Look(evidence, 2, Around(0), 3);
  Look(evidence, 2, Around(30), 3);
  EXPECT_GT(evidence.log_odds(), 3);
  EXPECT_LT(evidence.log_odds(), 4);
  EXPECT_EQ(evidence.supporting_views(), 2);
  PlaceEvidence nearer;
  Look(nearer, 2, Around(0, 3), 3);
  Look(nearer, 2, Around(0, 1.5), 3);
  EXPECT_EQ(nearer.supporting_views(), 2) << "half the distance is another view";
}

TEST(PlaceEvidence, ASmallStepIsNoNewViewpoint) {
  PlaceEvidence evidence;
  Look(evidence, 2, Around(0), 3);
  Look(evidence, 2, Around(10, 2.2), 3);
  EXPECT_LT(evidence.log_odds(), 2 + 1e-9);
  EXPECT_EQ(evidence.supporting_views(), 1);
}

TEST(PlaceEvidence, ContradictionFromTheSameViewpointReplacesWhatItSaid) {
  PlaceEvidence evidence;
  Look(evidence, 4, Around(0), 10);
  Look(evidence, -1.5, Around(0), 10);
  EXPECT_NEAR(evidence.log_odds(), -1.5, 1e-6);
}

TEST(PlaceEvidence, WhatOtherViewpointsSaidFadesWhileThePlaceIsSeen) {
  PlaceEvidence evidence;
  Look(evidence, 4, Around(0), 10);
  Look(evidence, -1.5, Around(90), 60);
  EXPECT_NEAR(evidence.log_odds(), -1.5, 1e-3);
  EXPECT_EQ(evidence.supporting_views(), 1);
}

TEST(PlaceEvidence, RoundTheWorldManyTimesStaysFinite) {
  PlaceEvidence evidence;
  for (int i = 0; i < 5000; ++i)
    evidence.Add(4, Around(7.0 * i, 0.1 + 0.01 * (i % 400)), 0.1, kConfig);
  EXPECT_TRUE(std::isfinite(evidence.log_odds()));
  EXPECT_LE(evidence.supporting_views(), 64);
  evidence.Add(4, Eigen::Vector3d::Zero(), 0.1, kConfig);
  EXPECT_TRUE(std::isfinite(evidence.log_odds()));
}

}  // namespace
}  // namespace fallen
